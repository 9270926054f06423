// SPDX-License-Identifier: BSD-3-Clause
// A duration by its name: what bench.json keeps and what a later run is compared with.
#pragma once

#include <string>
#include <string_view>

#include "base/statistics.h"

namespace armature {

// Spans that are no stage.
inline constexpr std::string_view kTotal = "total";
// Association and optimization together: what comes for each object once lines are found.
inline constexpr std::string_view kProcessing = "association + optimization";
// The total without the detection.
inline constexpr std::string_view kOnTop = "on top";
// What the total holds beside the stages.
inline constexpr std::string_view kOther = "other";

struct NamedSpan {
  std::string table;      // "comparison", "objects", "detectors", "scaling", "micro"
  std::string sequence;   // its name; empty: fixed inputs
  std::string contender;  // "lines:default", "keypoints:hourglass", "hypothesis"
  std::string stage;      // a stage's name, or "total"
  SpanStatistics milliseconds;

  std::string Key() const { return table + "/" + sequence + "/" + contender + "/" + stage; }
};

// How many times as long as another contender one takes for the same, paired by frame and repetition.
struct NamedRatio {
  std::string table, sequence;
  std::string contender, reference;  // total of the contender over that of the reference
  SpanStatistics ratio;
};

}  // namespace armature
