// SPDX-License-Identifier: BSD-3-Clause
// Rotations in three dimensions: the exponential map of SO(3) and the few constructions that the stages
// share.
#pragma once

#include <Eigen/Geometry>

namespace armature {

constexpr double kDegree = 0.017453292519943295;  // radians

Eigen::Matrix3d Skew(const Eigen::Vector3d& v);

// exp: so(3) -> SO(3), the rotation by |w| radians about w.
Eigen::Matrix3d ExpSO3(const Eigen::Vector3d& w);

// The inverse of ExpSO3, |w| <= pi.
Eigen::Vector3d LogSO3(const Eigen::Matrix3d& R);

// J_l with ExpSO3(w + dw) = ExpSO3(J_l dw) ExpSO3(w) to first order.
Eigen::Matrix3d LeftJacobianSO3(const Eigen::Vector3d& w);

// Its inverse, |w| < 2 pi: LogSO3(ExpSO3(d) ExpSO3(w)) = w + J_l^-1 d to first order.
Eigen::Matrix3d LeftJacobianInverseSO3(const Eigen::Vector3d& w);

// The smallest rotation that takes the direction `from` to the direction `to`; neither needs unit length.
Eigen::Matrix3d SmallestRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

// The angle wrapped to [-pi, pi).
double WrapAngle(double angle);

}  // namespace armature
