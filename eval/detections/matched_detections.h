// SPDX-License-Identifier: BSD-3-Clause
// Detections of one image and the true objects that they are of.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "association/detection.h"
#include "eval/detections/true_boxes.h"

namespace armature {

// What a detection is.
enum class DetectionVerdict {
  kRight,          // of a true object, the first of it
  kDuplicate,      // of one that a detection with a higher score is of
  kWrongCategory,  // on one of another category
  kFalseAlarm,     // on none
  kNotJudged       // of one of which too little is seen to be asked for
};

struct MatchedDetection {
  DetectionVerdict verdict = DetectionVerdict::kFalseAlarm;
  std::optional<size_t> seen;  // place in the list of seen boxes: what it is of, or on
  double iou = 0;              // with that one's box
};

// What is to be found of the seen.
bool IsAskedFor(const TrueBox& seen);

// One a detection. `categories`: of the true objects. By falling score each takes the box that it overlaps
// most: at least half (intersection over union) of what is seen of the object or of all of it in the image.
std::vector<MatchedDetection> MatchDetections(const std::vector<Detection>& detections,
                                              const std::vector<TrueBox>& seen,
                                              const std::vector<std::string>& categories);

}  // namespace armature
