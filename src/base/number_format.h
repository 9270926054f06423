// SPDX-License-Identifier: BSD-3-Clause
// Numbers as they are written to files: always the same bytes for the same value, whatever the locale.
#pragma once

#include <Eigen/Geometry>
#include <string>

namespace armature {

// Fixed digits after the point; never "-0.000"; empty for a value that is not finite.
std::string Fixed(double value, int digits);

// The rotation's quaternion of unit length with w >= 0 (with w = 0: the first of x, y, z that is not 0 is
// positive).
Eigen::Quaterniond CanonicalQuaternion(const Eigen::Matrix3d& rotation);

}  // namespace armature
