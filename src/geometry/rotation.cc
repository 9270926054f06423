// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/rotation.h"

#include <cmath>

namespace armature {

Eigen::Matrix3d Skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d S;
  S << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return S;
}

Eigen::Matrix3d ExpSO3(const Eigen::Vector3d& w) {
  const double angle = w.norm();
  if (angle < 1e-12) return Eigen::Matrix3d::Identity() + Skew(w);
  return Eigen::AngleAxisd(angle, w / angle).toRotationMatrix();
}

Eigen::Vector3d LogSO3(const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd angle_axis(R);
  return angle_axis.angle() * angle_axis.axis();
}

Eigen::Matrix3d LeftJacobianSO3(const Eigen::Vector3d& w) {
  const double angle = w.norm();
  const Eigen::Matrix3d W = Skew(w);
  // Below 1e-4 rad the closed form loses digits; its Taylor series is exact there to double precision.
  if (angle < 1e-4) return Eigen::Matrix3d::Identity() + 0.5 * W + W * W / 6.0;
  const double angle2 = angle * angle;
  return Eigen::Matrix3d::Identity() + (1 - std::cos(angle)) / angle2 * W +
         (angle - std::sin(angle)) / (angle2 * angle) * W * W;
}

Eigen::Matrix3d LeftJacobianInverseSO3(const Eigen::Vector3d& w) {
  const double angle2 = w.squaredNorm(), half = 0.5 * std::sqrt(angle2);
  const Eigen::Matrix3d W = Skew(w);
  // (1 - (t/2) cot(t/2)) / t^2 loses digits towards 0, where its Taylor series takes over.
  const double factor = half < 0.05 ? 1 / 12.0 + angle2 / 720 * (1 + angle2 / 42)
                                    : (1 - half * std::cos(half) / std::sin(half)) / angle2;
  return Eigen::Matrix3d::Identity() - 0.5 * W + factor * W * W;
}

// Eigen's own Quaterniond::FromTwoVectors decomposes a matrix for opposite vectors: as slow to compile as all
// the rest.
Eigen::Matrix3d SmallestRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  const double cosine = b.dot(a);
  if (cosine < -1 + 1e-12) return Eigen::AngleAxisd(M_PI, a.unitOrthogonal()).toRotationMatrix();
  const double twice_w = std::sqrt((1 + cosine) * 2);
  const Eigen::Vector3d axis = a.cross(b) * (1 / twice_w);
  return Eigen::Quaterniond(0.5 * twice_w, axis.x(), axis.y(), axis.z()).toRotationMatrix();
}

double WrapAngle(double angle) {
  const double turn = 2 * M_PI;
  return angle - turn * std::floor((angle + M_PI) / turn);
}

}  // namespace armature
