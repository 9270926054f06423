// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sections/bench_tables.h"

#include <algorithm>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "bench/sections/comparison_section.h"
#include "bench/sections/detectors_section.h"
#include "bench/sections/objects_section.h"
#include "bench/sections/pipelined_section.h"
#include "bench/sections/scaling_section.h"

namespace armature {

const std::vector<std::string>& BenchTableNames() {
  static const std::vector<std::string> names{"comparison", "objects",    "detectors", "scaling",
                                              "pipelined",  kMemoryTable, kMicroTable, kRetrievalTable};
  return names;
}

void CheckBenchTableName(const std::string& name) {
  const std::vector<std::string>& known = BenchTableNames();
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw InputError("--tables: " + UnknownNameMessage("table", name, known));
}

bool NeedsSequence(const std::string& table) { return table != kMicroTable && table != kRetrievalTable; }

BenchSection MeasureSection(const std::string& name, const BenchTask& task) {
  if (name == "comparison") return ComparisonSection(task);
  if (name == "objects") return ObjectsSection(task);
  if (name == "detectors") return DetectorsSection(task);
  if (name == kPipelinedTable) return PipelinedSection(task);
  return ScalingSection(task);
}

}  // namespace armature
