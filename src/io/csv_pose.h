// SPDX-License-Identifier: BSD-3-Clause
// Poses in tables.
#pragma once

#include <Eigen/Geometry>

#include "io/csv.h"

namespace armature {

// From the columns tx ty tz (metres) and qx qy qz qw. Throws InputError when one is missing, is not a finite
// number, or the quaternion's length is further than 1e-3 from 1.
Eigen::Isometry3d ReadPose(const CsvRow& row);

}  // namespace armature
