// SPDX-License-Identifier: BSD-3-Clause
#include "bench/bench_tables.h"

#include <algorithm>

#include "bench/comparison_section.h"
#include "bench/detectors_section.h"
#include "bench/objects_section.h"
#include "bench/scaling_section.h"
#include "io/errors.h"
#include "io/nearest_name.h"

namespace armature {

const std::vector<std::string>& BenchTableNames() {
  static const std::vector<std::string> names{"comparison", "objects", "detectors", "scaling"};
  return names;
}

void CheckBenchTableName(const std::string& name) {
  const std::vector<std::string>& known = BenchTableNames();
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw InputError("--tables: " + UnknownNameMessage("table", name, known));
}

BenchSection MeasureSection(const std::string& name, const BenchTask& task) {
  if (name == "comparison") return ComparisonSection(task);
  if (name == "objects") return ObjectsSection(task);
  if (name == "detectors") return DetectorsSection(task);
  return ScalingSection(task);
}

}  // namespace armature
