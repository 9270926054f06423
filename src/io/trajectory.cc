// SPDX-License-Identifier: BSD-3-Clause
#include "io/trajectory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "io/errors.h"
#include "io/number_format.h"
#include "io/text.h"

namespace armature {
namespace {

constexpr double kQuaternionTolerance = 1e-3;
constexpr double kRounding = 1e-6;  // seconds; what doubles keep of a stamp that counts from 1970, and more

TimedPose ParsePose(const TextLine& line, const std::string& where) {
  std::istringstream stream(line.text);
  std::vector<double> values;
  for (std::string field; stream >> field;) values.push_back(ParseNumber(field, where));
  if (values.size() != 8) {
    throw InputError(fmt::format("{}: {} numbers where a pose has 8; write 'timestamp tx ty tz qx qy qz qw'",
                                 where, values.size()));
  }
  const Eigen::Quaterniond rotation(values[7], values[4], values[5], values[6]);
  if (std::abs(rotation.norm() - 1) > kQuaternionTolerance) {
    throw InputError(
        fmt::format("{}: the quaternion has length {:.6g}, not 1; write qx qy qz qw of a unit quaternion",
                    where, rotation.norm()));
  }
  TimedPose pose{.timestamp = values[0], .line = line.number};
  pose.pose.linear() = rotation.normalized().toRotationMatrix();
  pose.pose.translation() = Eigen::Vector3d(values[1], values[2], values[3]);
  return pose;
}

void CheckOrder(const TimedPose& earlier, const TimedPose& later, RepeatedStamps repeated,
                const std::string& where) {
  if (later.timestamp > earlier.timestamp) return;
  if (later.timestamp == earlier.timestamp && repeated == RepeatedStamps::kKept) return;
  throw InputError(
      fmt::format("{}: stamp {:.6f} does not follow {:.6f} of line {}; sort the poses, one a stamp", where,
                  later.timestamp, earlier.timestamp, earlier.line));
}

}  // namespace

std::vector<TimedPose> ReadTumTrajectory(const std::filesystem::path& file, RepeatedStamps repeated) {
  std::vector<TimedPose> poses;
  for (const TextLine& line : ReadTextLines(file)) {
    const std::string where = fmt::format("{}:{}", file.string(), line.number);
    const TimedPose pose = ParsePose(line, where);
    if (!poses.empty()) CheckOrder(poses.back(), pose, repeated, where);
    poses.push_back(pose);
  }
  if (poses.empty()) {
    throw InputError(
        fmt::format("{}: has no pose; write lines 'timestamp tx ty tz qx qy qz qw'", file.string()));
  }
  return poses;
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

std::optional<size_t> IndexOfStamp(const std::vector<TimedPose>& poses, double timestamp, double tolerance) {
  const auto later = std::lower_bound(poses.begin(), poses.end(), timestamp,
                                      [](const TimedPose& pose, double t) { return pose.timestamp < t; });
  auto nearest = later;
  if (later == poses.end() ||
      (later != poses.begin() && timestamp - (later - 1)->timestamp < later->timestamp - timestamp)) {
    if (later == poses.begin()) return std::nullopt;
    nearest = later - 1;
  }
  if (std::abs(nearest->timestamp - timestamp) > tolerance + kRounding) return std::nullopt;
  return static_cast<size_t>(nearest - poses.begin());
}

}  // namespace armature
