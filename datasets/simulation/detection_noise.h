// SPDX-License-Identifier: BSD-3-Clause
// What a detector and a viewpoint estimator do wrong.
#pragma once

#include <map>
#include <string>

namespace armature {

// What comes in stretches comes frame by frame, each for itself, where its `_seconds` are 0. Shares are of
// time.
struct DetectionNoise {
  double box = 0.02;           // sigma of each side, share of the box's size
  double missed = 0.04;        // share of detections
  double false_alarms = 0.05;  // mean number an image
  double min_visible = 0.3;  // objects of which less is seen are not detected, share of their surface in view
  double min_size_px = 24;   // as are those whose box is narrower and lower
  double azimuth_deg = 10;   // sigmas of the viewpoint
  double elevation_deg = 4;
  double tilt_deg = 3;
  double turned = 0.04;  // share of viewpoints that are turned by 180 degrees

  // Errors that stay: a share of the variance is autoregressive and falls to 1/e within the seconds, the rest
  // is drawn for each frame.
  double box_lasting = 0, box_seconds = 1;
  double viewpoint_lasting = 0, viewpoint_seconds = 1;

  // Misses: mean length of a burst; how much the log odds of a miss differ between objects (sigma), and grow
  // from an object that is all seen to one of which nothing is.
  double missed_seconds = 0, missed_spread = 0, missed_hidden = 0;

  // Boxes of the wrong extent. Of what is partly hidden or out of the picture only a part is boxed, for a
  // share that grows with what is not seen: this one of an object of which nothing is. A table's box spans
  // the chairs that stand at it.
  double part = 0, part_seconds = 1;
  double spanning = 0, spanning_seconds = 1;

  // Boxes too many: another of the same object; one of a wrong category on it; on a distractor; and mean
  // number an image of this category of those that stay on something in the background.
  double duplicates = 0, duplicates_seconds = 1;
  double mistaken = 0, mistaken_seconds = 1;
  double distractors = 0, distractors_seconds = 1;
  double lasting_alarms = 0, lasting_alarms_seconds = 1;

  // Viewpoints that are not given, that are turned, and whose azimuth is off by 60 to 120 degrees.
  double no_viewpoint = 0, no_viewpoint_seconds = 1;
  double turned_seconds = 0;
  double astray = 0, astray_seconds = 1;
  double elevation_bias_deg = 0;

  // Scores: of an object of which nothing is seen, within 0.2; and how much more of one that is all seen.
  double score = 0.4, score_visible = 0.39;

  // All errors and shares times `factor`, shares at most 1. How long they stay, the limits of what is
  // detected and the scores are as they are.
  DetectionNoise Times(double factor) const;
};

// By category of what is detected: an object's true category, a false alarm's wrong one.
struct DetectorNoise {
  DetectionNoise any;                        // of categories that are not listed
  std::map<std::string, DetectionNoise> of;  // by category

  const DetectionNoise& Of(const std::string& category) const {
    const auto found = of.find(category);
    return found == of.end() ? any : found->second;
  }
  DetectorNoise Times(double factor) const;
};

}  // namespace armature
