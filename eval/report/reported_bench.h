// SPDX-License-Identifier: BSD-3-Clause
// What `armature bench --out` has left, as a report shows it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "drawing/plots/plot.h"
#include "drawing/plots/stacked_bars.h"
#include "io/named_span.h"
#include "io/text_table.h"

namespace armature {

// Time against something that grows, in milliseconds: medians, p10 and p90, a series a contender.
struct TimeCurves {
  std::string sequence;
  Plot plot;
};

// Median times of one sequence, a bar an engine.
struct StageBars {
  std::string sequence;
  StackedBars bars;
};

struct ReportedBench {
  std::vector<Table> tables;     // their names are those of their sections: "comparison", "objects", ...
  std::vector<NamedSpan> spans;  // milliseconds
  std::vector<NamedRatio> ratios;
  std::vector<TimeCurves> curves;
  size_t objects = 3;  // of the compared frames
  std::vector<std::pair<std::string, std::string>> environment;
};

// bench.json of the folder. Throws InputError: missing, unfinished or malformed.
ReportedBench ReadReportedBench(const std::filesystem::path& folder);

// The median stages of the comparison's engines, an entry a sequence.
std::vector<StageBars> MakeStageBars(const ReportedBench& bench);

}  // namespace armature
