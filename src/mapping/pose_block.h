// SPDX-License-Identifier: BSD-3-Clause
// A pose as a parameter block of Ceres.
//
// The block is 7 numbers: translation, then quaternion (x, y, z, w). Costs derive by the step d = (rotation,
// translation) of X Exp(d) and write that into the block's first six columns, 0 into the seventh:
// PoseManifold's plus has the derivative (I; 0), so the chain rule leaves the six as they are. That spares
// everyone the 7x6 derivative of the quaternion. It does not hold for Ceres' automatic derivatives, which
// derive by the seven numbers.
#pragma once

#include <ceres/manifold.h>

#include <Eigen/Geometry>

namespace armature {

using PoseBlock = Eigen::Matrix<double, 7, 1>;
PoseBlock ToBlock(const Eigen::Isometry3d& pose);
Eigen::Isometry3d FromBlock(const double* block);

// Stores derivatives by the step d (rows x 6) as those by the block (rows x 7, row-major).
template <typename Derived>
void StoreByStep(const Eigen::MatrixBase<Derived>& by_step, double* jacobian) {
  using ByBlock = Eigen::Matrix<double, Derived::RowsAtCompileTime, 7, Eigen::RowMajor>;
  Eigen::Map<ByBlock> by_block(jacobian, by_step.rows(), 7);
  by_block.template leftCols<6>().noalias() = by_step;
  by_block.col(6).setZero();
}

// Plus moves by (R v, exp(w)), which is Exp(w, v) to first order; Minus is its exact inverse.
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
