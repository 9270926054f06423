// SPDX-License-Identifier: BSD-3-Clause
// A duration by its name: what bench.json keeps and what a later run is compared with.
#pragma once

#include <string>

#include "bench/span_statistics.h"

namespace armature {

struct NamedSpan {
  std::string table;      // "comparison", "objects", "detectors", "scaling", "micro"
  std::string sequence;   // its name; empty: fixed inputs
  std::string contender;  // "lines:default", "keypoints:hourglass", "hypothesis"
  std::string stage;      // a stage's name, or "total"
  SpanStatistics milliseconds;

  std::string Key() const { return table + "/" + sequence + "/" + contender + "/" + stage; }
};

}  // namespace armature
