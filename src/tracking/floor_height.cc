// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/floor_height.h"

#include <algorithm>
#include <cmath>

namespace armature {
namespace {

// Tuned on office_dev and redkitchen_a.
constexpr double kHeightDrift = 0.1;  // metres per square root of a second, where the odometry cannot tell
constexpr double kClimbError = 0.15;  // share of the odometry's climb, its scale being as the objects give it
constexpr double kSizeSigma = 0.07;   // share by which furniture differs from its category's reference
constexpr double kLeastHeightSigma = 0.03;  // metres: never surer than this

}  // namespace

double CameraHeightAbove(const Wireframe& wireframe, const Eigen::Isometry3d& T_camera_object,
                         const Eigen::Vector3d& up_camera) {
  const Eigen::RowVector3d up = up_camera.transpose() * T_camera_object.linear();
  const double lowest = (up * wireframe.midpoints - (up * wireframe.directions).cwiseAbs() / 2).minCoeff();
  return -(lowest + up_camera.dot(T_camera_object.translation()));
}

std::optional<FloorPrior> FloorHeight::Predict(double timestamp, std::optional<double> climb) {
  if (!options_.enabled) return std::nullopt;
  if (known_) return known_;
  if (last_timestamp_) {
    const double passed = std::sqrt(std::max(0.0, timestamp - *last_timestamp_));
    // Even a climb that is known leaves slow errors: of the up direction, of the scale.
    const double drift =
        climb ? std::hypot(kClimbError * *climb, 0.2 * kHeightDrift * passed) : kHeightDrift * passed;
    height_ += climb.value_or(0);
    sigma_ = std::min(options_.initial_sigma, std::hypot(sigma_, drift));
  }
  last_timestamp_ = timestamp;
  return FloorPrior{height_, sigma_};
}

// One step of a scalar Kalman filter with a robust gate. The floor was a prior of the estimate, so the
// innovation is partly the prior's own; inflating the measurement's variance keeps the filter from believing
// itself.
void FloorHeight::Update(const SingleViewResult& result, const CategoryModel& model,
                         const Eigen::Vector3d& up_camera) {
  if (!options_.enabled || known_ || !model.spec.stands_on_floor) return;
  const Wireframe wireframe = WireframeFromCoefficients(model, result.measured.estimate.coefficients);
  const double measured = CameraHeightAbove(wireframe, result.measured.estimate.T_camera_object, up_camera);
  const double along_up = up_camera.transpose() * result.measured.covariance.block<3, 3>(3, 3) * up_camera;
  const double size = kSizeSigma * std::abs(measured);
  const double sigma = 3 * std::sqrt(along_up + size * size);
  const double innovation = measured - height_;
  const double off = innovation * innovation / (sigma_ * sigma_ + sigma * sigma / 9);
  const double gain = sigma_ * sigma_ / (sigma_ * sigma_ + sigma * sigma) / (1 + off / 4);
  height_ += gain * innovation;
  sigma_ = std::max(kLeastHeightSigma, sigma_ * std::sqrt(1 - gain));
}

}  // namespace armature
