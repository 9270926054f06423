// SPDX-License-Identifier: BSD-3-Clause
// What `armature bench --out` has left, as a report shows it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "eval/report/report_data.h"
#include "io/named_span.h"

namespace armature {

struct BenchResults {
  std::vector<Table> tables;     // their names are those of their sections: "comparison", "objects", ...
  std::vector<NamedSpan> spans;  // milliseconds
  std::vector<NamedRatio> ratios;
  std::vector<TimeCurves> curves;
  size_t objects = 3;  // of the compared frames
  std::vector<std::pair<std::string, std::string>> environment;
};

// bench.json of the folder. Throws InputError: missing, unfinished or malformed.
BenchResults ReadBenchResults(const std::filesystem::path& folder);

// The median stages of the comparison's engines, an entry a sequence.
std::vector<StageBars> MakeStageBars(const BenchResults& bench);

}  // namespace armature
