// SPDX-License-Identifier: BSD-3-Clause
// A pose as a parameter block of Ceres.
//
// The block is (qx, qy, qz, qw, tx, ty, tz) of T. A step d = (w, v), rotation first, moves it on the right:
//   T [+] d = T Exp(d)   in SE(3).
// A cost function that uses the block writes its exact Jacobian by d into the first six columns and 0 into
// the seventh: PoseManifold's own Jacobian is [I; 0], so the chain rule leaves the six columns as they are.
// That spares the products with the 7x6 Jacobian of the quaternion. It does not hold for Ceres' automatic
// derivatives, which derive by the seven numbers.
#pragma once

#include <ceres/manifold.h>

#include <array>

#include "geometry/se3.h"

namespace armature {

using PoseBlock = std::array<double, 7>;
using PoseBlockJacobian = Eigen::Matrix<double, 6, 7, Eigen::RowMajor>;

PoseBlock ToPoseBlock(const Eigen::Isometry3d& T);
Eigen::Isometry3d FromPoseBlock(const double* block);

class PoseManifold : public ceres::Manifold {
 public:
  int AmbientSize() const override { return 7; }
  int TangentSize() const override { return 6; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override;
  bool PlusJacobian(const double* x, double* jacobian) const override;
  bool Minus(const double* y, const double* x, double* y_minus_x) const override;
  bool MinusJacobian(const double* x, double* jacobian) const override;
};

}  // namespace armature
