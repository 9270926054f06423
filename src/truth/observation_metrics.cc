// SPDX-License-Identifier: BSD-3-Clause
#include "truth/observation_metrics.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"
#include "truth/orientation_error.h"

namespace armature {
namespace {

double ComputeAzimuth(const Eigen::Isometry3d& T_camera_object) {
  return ViewpointFromRotation(T_camera_object.linear(), T_camera_object.translation()).azimuth;
}

std::vector<double> Column(const std::vector<ObservationError>& errors, double ObservationError::*field) {
  std::vector<double> values;
  for (const ObservationError& error : errors) values.push_back(error.*field);
  return values;
}

}  // namespace

ObservationError CompareObservation(const std::string& category, int symmetry_order, bool ok,
                                    const Eigen::Isometry3d& T_camera_object,
                                    const Eigen::Isometry3d& T_camera_object_true) {
  ObservationError error;
  error.category = category;
  error.ok = ok;
  error.azimuth_deg = std::abs(AzimuthDifference(ComputeAzimuth(T_camera_object),
                                                 ComputeAzimuth(T_camera_object_true), symmetry_order)) /
                      kDegree;
  error.translation_percent = 100 *
                              (T_camera_object.translation() - T_camera_object_true.translation()).norm() /
                              T_camera_object_true.translation().norm();
  error.distance_percent =
      100 * (T_camera_object.translation().norm() / T_camera_object_true.translation().norm() - 1);
  const OrientationError orientation =
      CompareOrientation(T_camera_object.linear(), T_camera_object_true.linear(), symmetry_order);
  error.elevation_axis_deg = orientation.tilt_deg;
  error.pitch_deg = orientation.pitch_deg;
  error.roll_deg = orientation.roll_deg;
  return error;
}

ObservationSummary Summarise(const std::vector<ObservationError>& errors) {
  ObservationSummary summary;
  summary.count = static_cast<int>(errors.size());
  if (errors.empty()) return summary;
  const auto share = [&](auto holds) {
    return static_cast<double>(std::count_if(errors.begin(), errors.end(), holds)) / summary.count;
  };
  summary.ok_share = share([](const ObservationError& e) { return e.ok; });
  summary.share_within_15_deg = share([](const ObservationError& e) { return e.azimuth_deg <= 15; });
  summary.median_azimuth_deg = Median(Column(errors, &ObservationError::azimuth_deg));
  summary.median_translation_percent = Median(Column(errors, &ObservationError::translation_percent));
  summary.median_distance_percent = Median(Column(errors, &ObservationError::distance_percent));
  summary.median_axis_deg = Median(Column(errors, &ObservationError::elevation_axis_deg));
  return summary;
}

}  // namespace armature
