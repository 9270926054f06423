// SPDX-License-Identifier: BSD-3-Clause
// What a call of `armature bench` has measured, as plain data: what is printed, drawn, written and compared.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/harness.h"
#include "bench/sections/line_fit.h"
#include "io/named_span.h"
#include "io/text_table.h"

namespace armature {

// A curve: times against what was varied.
struct BenchSeries {
  std::string contender;  // the engine, or the entrant
  std::string x_label, y_label;
  struct Point {
    double x = 0;
    SpanStatistics milliseconds;
  };
  std::vector<Point> points{};  // by growing x
  std::optional<LineFit> fit{};
  std::string remark{};  // beside its name in a picture: what the time buys
};

// One kind of measurement on one sequence, or on none.
struct BenchSection {
  std::string name;      // see bench/sections/bench_tables.h, or "against"
  std::string sequence;  // its name; empty: fixed inputs
  size_t frames = 0;     // counted, of one contender in one repetition
  size_t warmed_up = 0;  // frames that were processed before, but not counted
  std::vector<Table> tables{};
  std::vector<NamedSpan> spans{};
  std::vector<NamedRatio> ratios{};
  std::vector<BenchSeries> series{};
  std::vector<BenchRow> rows{};          // without estimates
  std::vector<double> calibration_ms{};  // passes of the calibration loop, which took turns with the rows
};

struct BenchReport {
  std::vector<BenchSection> sections;
};

}  // namespace armature
