// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulation/viewpoint_errors.h"

#include <cmath>

#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {

double ViewpointErrors::Astray(const DetectionNoise& noise, double time) {
  const bool is_astray = astray_.IsOn(noise.astray, noise.astray_seconds, time, random_);
  if (astray_.has_begun()) {
    const double sign = random_.Uniform(0, 1) < 0.5 ? -1 : 1;
    astray_by_ = sign * random_.Uniform(60, 120) * kDegree;
  }
  return is_astray ? astray_by_ : 0;
}

void ViewpointErrors::Apply(const Eigen::Matrix3d& R_camera_object, const Camera& camera,
                            const DetectionNoise& noise, double time, Random& frame, Detection* detection) {
  const Viewpoint truth = ViewpointFromRotation(R_camera_object, camera.Ray(detection->box.center()));
  const double fresh = std::sqrt(1 - noise.viewpoint_lasting) * kDegree;
  const double lasting = std::sqrt(noise.viewpoint_lasting) * kDegree;
  std::array<double, 3> stays;
  for (size_t i = 0; i < stays.size(); ++i)
    stays[i] = lasting * angles_[i].At(time, noise.viewpoint_seconds, random_);
  const double turn = turned_.IsOn(noise.turned, noise.turned_seconds, time, frame) ? 180 * kDegree : 0;
  const double azimuth = frame.Normal(truth.azimuth + turn, fresh * noise.azimuth_deg);
  const double elevation = frame.Normal(truth.elevation, fresh * noise.elevation_deg);
  const double tilt = frame.Normal(truth.tilt, fresh * noise.tilt_deg);
  const double astray = Astray(noise, time);
  if (missing_.IsOn(noise.no_viewpoint, noise.no_viewpoint_seconds, time, random_)) return;
  detection->azimuth = WrapAngle(azimuth + stays[0] * noise.azimuth_deg + astray);
  detection->elevation = elevation + stays[1] * noise.elevation_deg + noise.elevation_bias_deg * kDegree;
  detection->tilt = tilt + stays[2] * noise.tilt_deg;
}

}  // namespace armature
