// SPDX-License-Identifier: BSD-3-Clause
// What a table is measured on, and how.
#pragma once

#include <string>
#include <vector>

#include "bench/engines.h"
#include "bench/harness.h"
#include "bench/sections/frame_truth.h"

namespace armature {

struct BenchSettings {
  HarnessOptions harness;
  int threads = 1;                   // of OpenCV: line detectors and the network; the rest has one
  std::vector<std::string> engines;  // full names; ratios refer to the first
  size_t objects = 3;                // of the frames that the comparison is of
  size_t baseline_frames = 20;       // about so many of them are given to a baseline
};

struct BenchTask {
  const BenchSequence& sequence;
  const std::vector<FrameTruth>& truth;  // one a frame; empty: there is none
  const EngineParts& parts;
  const BenchSettings& settings;
};

}  // namespace armature
