// SPDX-License-Identifier: BSD-3-Clause
// Rows, engines and sequences of which the right tables are known.
#pragma once

#include <string>
#include <vector>

#include "bench/harness.h"

namespace armature::testing {

// Frames without pixels, with so many boxes each; the i-th of a frame is i + 1 pixels wide.
inline BenchSequence BoxSequence(const std::vector<size_t>& objects) {
  BenchSequence sequence{"boxes", {64, 48, 60, 61, 31.5, 23.5, {}}, {}, false, {}};
  for (size_t i = 0; i < objects.size(); ++i) {
    BenchFrame& frame = sequence.frames.emplace_back();
    frame.input.timestamp = 0.1 * static_cast<double>(i);
    for (size_t k = 0; k < objects[i]; ++k)
      frame.input.detections.push_back({"chair", {4, 8, 1.0 + static_cast<double>(k), 10}, 1, {}, {}, {}});
  }
  return sequence;
}

// Says that it took 1 ms for the detection and counts 100 ms an object without waiting.
class CountingEngine : public Engine {
 public:
  explicit CountingEngine(bool stateless) : stateless_(stateless) {}
  std::string Description() const override { return "counts without waiting"; }
  bool IsStateless() const override { return stateless_; }
  void Start(const BenchSequence&) override { ++starts; }
  FrameOutcome Process(const BenchFrame& frame) override {
    seen.push_back(frame.input.timestamp);
    FrameOutcome outcome;
    outcome.objects = static_cast<int>(frame.input.detections.size());
    outcome.added_ms = 100 * outcome.objects;
    outcome.stage(BenchStage::kDetection) = 1 + outcome.added_ms;
    outcome.estimates.resize(frame.input.detections.size());
    return outcome;
  }

  int starts = 0;
  std::vector<double> seen;  // stamps of the frames

 private:
  bool stateless_;
};

// A row with detection, association and optimization; the total is their sum and 1 ms more.
inline BenchRow MakeRow(const std::string& contender, size_t input, double detection, double association,
                        double optimization) {
  BenchRow row{.contender = contender, .input = input, .outcome = {}};
  row.outcome.stage(BenchStage::kDetection) = detection;
  row.outcome.stage(BenchStage::kAssociation) = association;
  row.outcome.stage(BenchStage::kOptimization) = optimization;
  row.outcome.objects = 2;
  row.wall_ms = detection + association + optimization + 1;
  return row;
}

}  // namespace armature::testing
