// SPDX-License-Identifier: BSD-3-Clause
// How far single-view estimates are from the truth.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace armature {

// One detection's estimate against the truth.
struct ObservationError {
  std::string category;
  bool ok = false;                 // the estimate's status
  double azimuth_deg = 0;          // absolute, degrees, the category's symmetry taken into account
  double translation_percent = 0;  // |t - t_true| in percent of |t_true|
  double distance_percent = 0;     // |t| - |t_true| in percent of |t_true|: negative when too near
  double elevation_axis_deg = 0;   // between the estimated and the true y axis of the object, degrees
  double pitch_deg = 0;            // of that, about the object's own x axis, signed; see OrientationError
  double roll_deg = 0;             // of that, about the object's own z axis, signed
};

// Azimuth as geometry/viewpoint.h defines it, each seen along its own ray.
ObservationError CompareObservation(const std::string& category, int symmetry_order, bool ok,
                                    const Eigen::Isometry3d& T_camera_object,
                                    const Eigen::Isometry3d& T_camera_object_true);

// Of all detections with an estimate, whatever its status.
struct ObservationSummary {
  int count = 0;
  double ok_share = 0;             // 0..1
  double median_azimuth_deg = 0;   // degrees
  double share_within_15_deg = 0;  // 0..1
  double median_translation_percent = 0;
  double median_distance_percent = 0;  // signed: a common error of scale shows here
  double median_axis_deg = 0;          // degrees
};
ObservationSummary Summarise(const std::vector<ObservationError>& errors);

}  // namespace armature
