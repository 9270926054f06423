// SPDX-License-Identifier: BSD-3-Clause
// What speaks for and against the pose that was found for an object in one image.
#pragma once

#include "association/object_view.h"
#include "resection/object_estimate.h"

namespace armature {

struct ViewEvidence {
  int edges = 0;               // that segments were matched to
  double cost = 0;             // of the association, see association/hypothesis_cost.h
  double depth_sigma = 0;      // of the distance, share of it
  double margin = 0;           // by which a clearly different pose costs more; at most kMostMargin
  int hidden_sides = 0;        // of the box, that something was taken to hide
  double hideable_sides = 0;   // sum of the probabilities that something hides them
  bool has_viewpoint = false;  // the detector gave a prior
};

inline constexpr double kMostMargin = 10;

// All but the margin.
ViewEvidence CollectViewEvidence(const ObjectView& view, const BoxSides& sides,
                                 const ObjectEstimate& estimate);

// ObjectEstimate::probability. A logistic regression on 22532 views of 100 development rooms, half of them
// with a network's detections; by rooms held out in turn its expected calibration error is 0.01, of either
// kind of detections alone below 0.04.
double ComputeProbability(const ViewEvidence& evidence);

}  // namespace armature
