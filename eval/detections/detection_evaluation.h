// SPDX-License-Identifier: BSD-3-Clause
// How good the detections of a sequence are.
#pragma once

#include <string>
#include <vector>

#include "association/detection.h"
#include "category/category_model.h"
#include "io/evaluation_records.h"
#include "truth/sequence_truth.h"

namespace armature {

struct DetectedFrame {
  double timestamp = 0;  // seconds
  std::vector<Detection> detections;
};

// A record of all categories together, with none of its own category, after one of each category that is
// among the true objects or the detections. Frames, by growing stamps, without true camera are left out.
std::vector<DetectionRecord> EvaluateDetections(const std::vector<DetectedFrame>& frames,
                                                const SequenceTruth& sequence,
                                                const std::vector<CategoryModel>& models);

}  // namespace armature
