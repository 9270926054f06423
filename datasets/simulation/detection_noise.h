// SPDX-License-Identifier: BSD-3-Clause
// What a detector and a viewpoint estimator do wrong.
#pragma once

namespace armature {

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

  // All of them times `factor`, shares at most 1 and the limits of what is detected as they are.
  DetectionNoise Times(double factor) const;
};

}  // namespace armature
