// SPDX-License-Identifier: BSD-3-Clause
#include "io/trajectory.h"

#include <fmt/format.h>

#include <fstream>

#include "base/number_format.h"
#include "io/trajectory_formats.h"

namespace armature {

std::vector<TimedPose> ReadTumTrajectory(const std::filesystem::path& file, RepeatedStamps repeated) {
  return ReadTrajectory(file, {.format = TrajectoryFormat::kTum, .repeated = repeated});
}

std::string TumLine(const TimedPose& pose) {
  const Eigen::Vector3d t = pose.pose.translation();
  const Eigen::Quaterniond q = CanonicalQuaternion(pose.pose.linear());
  return fmt::format("{} {} {} {} {} {} {} {}", Fixed(pose.timestamp, 6), Fixed(t.x(), 9), Fixed(t.y(), 9),
                     Fixed(t.z(), 9), Fixed(q.x(), 9), Fixed(q.y(), 9), Fixed(q.z(), 9), Fixed(q.w(), 9));
}

void WriteTumTrajectory(const std::filesystem::path& file, const std::vector<TimedPose>& poses) {
  std::ofstream stream(file);
  stream << "# timestamp tx ty tz qx qy qz qw\n";
  for (const TimedPose& pose : poses) stream << TumLine(pose) << '\n';
  stream.close();
  if (!stream) throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
}

}  // namespace armature
