// SPDX-License-Identifier: BSD-3-Clause
// Where to start (paper Algorithm 1): dictionary x viewpoints x translations around the priors.
#pragma once

#include <vector>

#include "association/box_constraints.h"
#include "association/object_view.h"

namespace armature {

struct HypothesisOptions {
  bool use_viewpoint = true;         // of the detections; without, all azimuths are tried
  double azimuth_spread_deg = 30;    // degrees either side of the prior
  double azimuth_step_deg = 15;      // degrees
  int horizontal_peaks = 2;          // azimuths to try where the horizontal segments of the box vanish
  double depth_factor = 1.25;        // the box's depth is also tried divided and multiplied by this; 1: not
  bool hidden_sides = true;          // also try that a side of the box is where something hides the object
  bool printed_translation = false;  // the paper's equations instead of all sides of the box
};

struct Hypothesis {
  PoseAndShape start;
  int dictionary_index = -1;  // of its shape, -1: the remembered one
  BoxSides sides{};           // which sides of the box it takes to be seen
  double azimuth = 0;         // radians
};

// Azimuths (radians) to try: around the prior, all round without one, and where horizontal segments say.
std::vector<double> CandidateAzimuths(const ObjectView& view, const HypothesisOptions& options);

// Azimuths under which horizontal edges of the category point along the horizontal directions that most
// segments in the box share. With `up` known, a segment whose plane through the camera has normal n, if it is
// horizontal in the world, runs along up x n: each segment votes for a turn about up without any knowledge of
// translation or size.
std::vector<double> FindHorizontalAzimuths(const ObjectView& view, double prior_azimuth, double spread,
                                           int max_peaks);

// What is remembered first, then the most likely: near the prior's azimuth. `dictionary`: the wireframes of
// the model's dictionary.
std::vector<Hypothesis> MakeHypotheses(const ObjectView& view, const std::vector<Wireframe>& dictionary,
                                       const BoxOptions& box_options, const HypothesisOptions& options);

}  // namespace armature
