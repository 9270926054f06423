// SPDX-License-Identifier: BSD-3-Clause
// What was found in frames, against the truth: the accuracy that a table of times has beside it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bench/sections/frame_truth.h"
#include "resection/object_estimate.h"
#include "truth/observation_metrics.h"

namespace armature {

// Pixels of true visible edges.
struct EdgeRecall {
  double visible = 0;
  double covered = 0;  // beside which some segment runs, see CoveredLength of truth/visible_edges.h
};

struct Findings {
  std::map<std::string, EdgeRecall> recall;  // by category, of objects whose own edges are known
  int detections = 0;                        // of a true object
  std::vector<ObservationError> errors;      // of those of them with a pose
};

// Adds a frame: undistorted segments, and an estimate a detection.
void AddFindings(const FrameTruth& truth, const std::vector<Segment>& segments,
                 const std::vector<ObjectEstimate>& estimates, Findings& findings);

// Of all categories together.
EdgeRecall AllRecall(const Findings& findings);

// Medians are over the detections with a pose, shares are of all detections; 0..1.
struct Accuracy {
  double azimuth_deg = 0, translation_percent = 0;
  double within_15_deg = 0, with_pose = 0;
};
// None without any pose of a true object.
std::optional<Accuracy> ComputeAccuracy(const Findings& findings);

// Whether errors are at most `margin` (a share) larger, and shares at most as much smaller.
bool IsAsAccurate(const Accuracy& one, const Accuracy& reference, double margin);

}  // namespace armature
