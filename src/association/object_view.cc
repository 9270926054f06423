// SPDX-License-Identifier: BSD-3-Clause
#include "association/object_view.h"

#include <cmath>

#include "geometry/rotation.h"

namespace armature {

double YawBelief::At(double yaw) const {
  const double position =
      (WrapAngle(yaw) + M_PI) / (2 * M_PI) * kBins - 0.5;  // bin centres are at whole numbers
  const double below = std::floor(position);
  const auto bin = [&](int offset) {
    return cost[static_cast<size_t>((static_cast<int>(below) + offset + kBins) % kBins)];
  };
  const double share = position - below;
  return (1 - share) * bin(0) + share * bin(1);
}

Eigen::Vector3d TrackPrior::AheadOfFront() const {
  // y x z = x: the front turns towards the object's x axis as the yaw grows.
  return expected.T_camera_object.linear().col(0);
}

TrackPriorVector TrackPrior::Difference(const Eigen::Matrix3d& R_camera_object, const Eigen::Vector3d& T,
                                        const Eigen::Ref<const Eigen::VectorXd>& coefficients) const {
  TrackPriorVector difference(4 + coefficients.size());
  difference.head<3>() = T - expected.T_camera_object.translation();
  difference(3) = AheadOfFront().dot(R_camera_object.col(2));
  difference.tail(coefficients.size()) = coefficients - expected.coefficients;
  return difference;
}

}  // namespace armature
