// SPDX-License-Identifier: BSD-3-Clause
// What a viewpoint estimator does to the views of one object.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>

#include "association/detection.h"
#include "datasets/simulation/detection_noise.h"
#include "datasets/simulation/lasting_error.h"
#include "datasets/simulation/stretches.h"
#include "geometry/camera.h"
#include "geometry/random.h"

namespace armature {

class ViewpointErrors {
 public:
  explicit ViewpointErrors(std::uint64_t seed) : random_(seed) {}

  // Sets the viewpoint that is seen along the ray through the middle of the detection's box, with its errors;
  // none where it is missing. `frame`: what is drawn for this frame alone.
  void Apply(const Eigen::Matrix3d& R_camera_object, const Camera& camera, const DetectionNoise& noise,
             double time, Random& frame, Detection* detection);

 private:
  // Radians to add to the azimuth: it stays for a stretch.
  double Astray(const DetectionNoise& noise, double time);

  Random random_;
  std::array<LastingError, 3> angles_;
  Stretches missing_, turned_, astray_;
  double astray_by_ = 0;  // radians
};

}  // namespace armature
