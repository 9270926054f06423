// SPDX-License-Identifier: BSD-3-Clause
#include "io/csv_pose.h"

#include <cmath>

#include "base/errors.h"

namespace armature {

Eigen::Isometry3d ReadPose(const CsvRow& row) {
  const Eigen::Quaterniond q(row.Number("qw"), row.Number("qx"), row.Number("qy"), row.Number("qz"));
  if (std::abs(q.norm() - 1) > 1e-3)
    throw InputError(row.At("the quaternion has not unit length; normalise it"));
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = q.normalized().toRotationMatrix();
  // Not by Eigen's comma initialiser: it must not be left half way, as by a number that cannot be read.
  pose.translation() = Eigen::Vector3d(row.Number("tx"), row.Number("ty"), row.Number("tz"));
  return pose;
}

}  // namespace armature
