// SPDX-License-Identifier: BSD-3-Clause
#include "truth/orientation_error.h"

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/rotation.h"
#include "truth/visible_edges.h"

namespace armature {

OrientationError CompareOrientation(const Eigen::Matrix3d& R_estimated, const Eigen::Matrix3d& R_true,
                                    int symmetry_order) {
  OrientationError error;
  error.symmetry_step = NearestSymmetryStep(R_estimated, R_true, symmetry_order);
  const Eigen::Matrix3d R_turned = R_true * TurnAboutY(symmetry_order, error.symmetry_step);
  const Eigen::Quaterniond relative(Eigen::Matrix3d(R_turned.transpose() * R_estimated));
  // relative = turn * tilt: the tilt's axis has no y component where the turn has all of the quaternion's y.
  Eigen::Quaterniond turn(relative.w(), 0, relative.y(), 0);
  if (turn.norm() < 1e-9) turn.setIdentity();  // upside down: any turn will do
  const Eigen::AngleAxisd tilt(turn.normalized().conjugate() * relative);
  const Eigen::Vector3d tilt_deg = tilt.angle() / kDegree * tilt.axis();
  error.azimuth_deg = WrapAngle(2 * std::atan2(turn.y(), turn.w())) / kDegree;
  error.pitch_deg = tilt_deg.x();
  error.roll_deg = tilt_deg.z();
  error.tilt_deg = tilt_deg.norm();
  return error;
}

}  // namespace armature
