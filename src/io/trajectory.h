// SPDX-License-Identifier: BSD-3-Clause
// Trajectories on disk: written in the TUM format, a pose a line, `timestamp tx ty tz qx qy qz qw`, blanks
// between. For other formats see io/trajectory_formats.h.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

#include "geometry/timed_pose.h"

namespace armature {

// Motion capture systems write the same stamp twice at times; the poses of a camera must not.
enum class RepeatedStamps { kRejected, kKept };

// The poses in the order of the file, their quaternions normalised. Throws InputError when the file cannot be
// read, has no pose, a line has not 8 finite numbers, stamps do not grow, or a quaternion's length is further
// than 1e-3 from 1.
std::vector<TimedPose> ReadTumTrajectory(const std::filesystem::path& file,
                                         RepeatedStamps repeated = RepeatedStamps::kRejected);

// "timestamp tx ty tz qx qy qz qw", the stamp with 6 digits, the pose with 9, qw >= 0.
std::string TumLine(const TimedPose& pose);

// A commented header and one line a pose. Throws std::runtime_error when the file cannot be written.
void WriteTumTrajectory(const std::filesystem::path& file, const std::vector<TimedPose>& poses);

}  // namespace armature
