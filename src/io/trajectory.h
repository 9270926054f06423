// SPDX-License-Identifier: BSD-3-Clause
// Trajectories in the TUM format: a pose a line, `timestamp tx ty tz qx qy qz qw`, blanks between.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace armature {

constexpr double kStampTolerance = 1e-3;  // seconds: two stamps closer than this are the same

struct TimedPose {
  double timestamp = 0;  // seconds
  Eigen::Isometry3d pose =
      Eigen::Isometry3d::Identity();  // T_world_camera or T_odom_camera, as the file says
  int line = 0;                       // of the file it was read from
};

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

// The pose whose stamp is nearest, if it is within the tolerance. Poses by growing stamps.
std::optional<size_t> IndexOfStamp(const std::vector<TimedPose>& poses, double timestamp,
                                   double tolerance = kStampTolerance);

}  // namespace armature
