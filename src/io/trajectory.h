// SPDX-License-Identifier: BSD-3-Clause
// Trajectories on disk: written in the TUM format, read as the usual data sets and systems write them. A line
// a pose; blank lines and '#' comments are skipped.
//   TUM:   `timestamp tx ty tz qx qy qz qw`, seconds, blanks between.
//   KITTI: the 12 numbers of the rows of [R | t], blanks between, no stamp.
//   EuRoC: `timestamp,p_x,p_y,p_z,q_w,q_x,q_y,q_z`, commas between, whole nanoseconds, the real part first;
//          further columns (velocity, biases) are skipped. The file's poses are of the body (the IMU): they
//          are taken as they are and not brought to a camera.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

#include "geometry/timed_pose.h"

namespace armature {

// Motion capture systems write the same stamp twice at times: of the truth all are kept. So do systems that
// estimate: a camera has one pose at a time, the first.
enum class RepeatedStamps { kFirstKept, kKept };

// The poses in the order of the file, their quaternions normalised, the first of a stamp. Throws InputError
// when the file cannot be read, has no pose, a line has not 8 finite numbers, a stamp is less than the one
// before, or a quaternion's length is further than 1e-3 from 1.
std::vector<TimedPose> ReadTumTrajectory(const std::filesystem::path& file);

// "timestamp tx ty tz qx qy qz qw", the stamp with 6 digits, the pose with 9, qw >= 0.
std::string TumLine(const TimedPose& pose);

// A commented header and one line a pose. Throws std::runtime_error when the file cannot be written.
void WriteTumTrajectory(const std::filesystem::path& file, const std::vector<TimedPose>& poses);

enum class TrajectoryFormat { kAuto, kTum, kKitti, kEuroc };

// "auto", "tum", "kitti", "euroc"; throws InputError for another name.
TrajectoryFormat TrajectoryFormatFromName(const std::string& name);

struct TrajectoryReading {
  // kAuto: by the first line: EuRoC with commas, else TUM with 8 numbers and KITTI with 12.
  TrajectoryFormat format = TrajectoryFormat::kAuto;
  RepeatedStamps repeated = RepeatedStamps::kFirstKept;
  // For KITTI alone: the stamp of each line, seconds; empty: the line's number from 0, over the rate.
  std::vector<double> stamps{};
  double rate = 1;  // poses a second, > 0
};

// The poses in the order of the file, rotations normalised. Throws InputError naming file, line and remedy:
// the file cannot be read, has no pose, its format is not told by the first line, a line is not in the format
// of the first or has a number that is not finite, a stamp is less than the one before, a quaternion's length
// is further than 1e-3 from 1, a matrix is further than 1e-3 from a rotation, or there are not as many KITTI
// lines as stamps.
struct TrajectoryFile {
  std::vector<TimedPose> poses;
  size_t repeated = 0;       // poses that were left out, as their stamp is that of the one before
  bool is_numbered = false;  // the stamps are numbers of lines: the file and the caller have none
};
TrajectoryFile ReadTrajectoryFile(const std::filesystem::path& file, const TrajectoryReading& reading = {});

// "file: 3 poses have ...; the first of each stamp is kept": what a user has to know of the reading; empty:
// nothing.
std::string DescribeRepeatedStamps(const std::filesystem::path& file, const TrajectoryFile& read);

// Only the poses.
std::vector<TimedPose> ReadTrajectory(const std::filesystem::path& file,
                                      const TrajectoryReading& reading = {});

// The first number of every line: a list of stamps (KITTI's times.txt), or rgb.txt. Throws InputError as
// above.
std::vector<double> ReadStamps(const std::filesystem::path& file);

}  // namespace armature
