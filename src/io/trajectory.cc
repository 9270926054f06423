// SPDX-License-Identifier: BSD-3-Clause
#include "io/trajectory.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "base/number_format.h"
#include "base/text.h"
#include "io/atomic_write.h"

namespace armature {
namespace {

constexpr double kRotationTolerance = 1e-3;

// How a format's lines look. A pose of a format with commas may have further fields.
struct LineLayout {
  const char* name;
  size_t fields;
  bool has_commas;
  const char* example;
};

const LineLayout& GetLayout(TrajectoryFormat format) {
  static const std::array<LineLayout, 3> layouts{{{"TUM", 8, false, "timestamp tx ty tz qx qy qz qw"},
                                                  {"KITTI", 12, false, "r11 r12 r13 tx r21 .. tz"},
                                                  {"EuRoC", 8, true, "timestamp,px,py,pz,qw,qx,qy,qz"}}};
  return layouts.at(static_cast<size_t>(format) - 1);
}

struct Fields {
  std::vector<std::string> texts;
  bool has_commas = false;

  bool Match(const LineLayout& layout) const {
    if (has_commas != layout.has_commas) return false;
    return has_commas ? texts.size() >= layout.fields : texts.size() == layout.fields;
  }
};

// At commas where the line has any, else at blanks.
Fields Split(const std::string& line) {
  Fields fields{{}, line.find(',') != std::string::npos};
  const char* separators = fields.has_commas ? "," : " \t";
  for (size_t begin = 0; begin <= line.size();) {
    const size_t end = std::min(line.find_first_of(separators, begin), line.size());
    if (fields.has_commas || end > begin) fields.texts.push_back(Trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return fields;
}

std::string Described(const Fields& fields) {
  return fmt::format("{} numbers{}", fields.texts.size(), fields.has_commas ? " between commas" : "");
}

TrajectoryFormat DetectFormat(const Fields& first, const std::string& where) {
  for (const auto format : {TrajectoryFormat::kTum, TrajectoryFormat::kKitti, TrajectoryFormat::kEuroc}) {
    if (first.Match(GetLayout(format))) return format;
  }
  throw InputError(
      fmt::format("{}: {} are no pose; write 8 for TUM ('timestamp tx ty tz qx qy qz qw'), 12 for KITTI, or "
                  "EuRoC's 'timestamp,px,py,pz,qw,qx,qy,qz'",
                  where, Described(first)));
}

Eigen::Matrix3d RotationFrom(const Eigen::Quaterniond& q, const std::string& where, const char* order) {
  if (std::abs(q.norm() - 1) > kRotationTolerance) {
    throw InputError(fmt::format("{}: the quaternion has length {:.6g}, not 1; write {} of a unit quaternion",
                                 where, q.norm(), order));
  }
  return q.normalized().toRotationMatrix();
}

TimedPose TumPose(const std::vector<double>& v, const std::string& where) {
  TimedPose pose{.timestamp = v[0]};
  pose.pose.linear() = RotationFrom({v[7], v[4], v[5], v[6]}, where, "qx qy qz qw");
  pose.pose.translation() << v[1], v[2], v[3];
  return pose;
}

TimedPose EurocPose(const std::vector<double>& v, const std::string& where) {
  if (v[0] != std::floor(v[0])) {
    throw InputError(
        fmt::format("{}: stamp {} is not in whole nanoseconds; write EuRoC's stamps, or the poses "
                    "in the TUM format, without commas",
                    where, v[0]));
  }
  TimedPose pose{.timestamp = v[0] * 1e-9};
  pose.pose.linear() = RotationFrom({v[4], v[5], v[6], v[7]}, where, "qw,qx,qy,qz");
  pose.pose.translation() << v[1], v[2], v[3];
  return pose;
}

TimedPose KittiPose(const std::vector<double>& v, const std::string& where) {
  const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> matrix(v.data());
  const Eigen::Matrix3d R = matrix.leftCols<3>();
  const double error = (R.transpose() * R - Eigen::Matrix3d::Identity()).norm();
  if (error > kRotationTolerance || R.determinant() < 0) {
    throw InputError(
        fmt::format("{}: the left 3 x 3 numbers are no rotation; write the rows of [R | t], R orthonormal, "
                    "right-handed",
                    where));
  }
  TimedPose pose;
  pose.pose.linear() = Eigen::Quaterniond(R).normalized().toRotationMatrix();
  pose.pose.translation() = matrix.col(3);
  return pose;
}

TimedPose ParsePose(const Fields& fields, TrajectoryFormat format, const std::string& where) {
  std::vector<double> values;
  for (size_t i = 0; i < GetLayout(format).fields; ++i) values.push_back(ParseNumber(fields.texts[i], where));
  if (format == TrajectoryFormat::kKitti) return KittiPose(values, where);
  return format == TrajectoryFormat::kTum ? TumPose(values, where) : EurocPose(values, where);
}

void CheckLayout(const Fields& fields, const LineLayout& layout, const std::string& where) {
  if (fields.Match(layout)) return;
  throw InputError(fmt::format("{}: {} where a {} pose has {}; write '{}' on every line", where,
                               Described(fields), layout.name, layout.fields, layout.example));
}

void CheckOrder(const TimedPose& earlier, const TimedPose& later, RepeatedStamps repeated,
                const std::string& where) {
  if (later.timestamp > earlier.timestamp) return;
  if (later.timestamp == earlier.timestamp && repeated == RepeatedStamps::kKept) return;
  throw InputError(
      fmt::format("{}: stamp {:.6f} does not follow {:.6f} of line {}; sort the poses, one a stamp", where,
                  later.timestamp, earlier.timestamp, earlier.line));
}

// KITTI's poses have no stamps of their own.
double ComputeLineStamp(size_t index, size_t lines, const TrajectoryReading& reading,
                        const std::filesystem::path& file) {
  if (reading.stamps.empty()) return static_cast<double>(index) / reading.rate;
  if (lines == reading.stamps.size()) return reading.stamps[index];
  throw InputError(fmt::format("{}: has {} poses for {} stamps; write one line of 12 numbers a stamp",
                               file.string(), lines, reading.stamps.size()));
}

}  // namespace

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
  std::string text = "# timestamp tx ty tz qx qy qz qw\n";
  for (const TimedPose& pose : poses) text += TumLine(pose) + "\n";
  WriteFile(file, text);
}

TrajectoryFormat TrajectoryFormatFromName(const std::string& name) {
  const std::vector<std::string> names{"auto", "tum", "kitti", "euroc"};
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw InputError(UnknownNameMessage("trajectory format", name, names));
  return static_cast<TrajectoryFormat>(found - names.begin());
}

std::vector<TimedPose> ReadTrajectory(const std::filesystem::path& file, const TrajectoryReading& reading) {
  const std::vector<TextLine> lines = ReadTextLines(file);
  TrajectoryFormat format = reading.format;
  std::vector<TimedPose> poses;
  for (const TextLine& line : lines) {
    const std::string where = fmt::format("{}:{}", file.string(), line.number);
    const Fields fields = Split(line.text);
    if (format == TrajectoryFormat::kAuto) format = DetectFormat(fields, where);
    CheckLayout(fields, GetLayout(format), where);
    TimedPose pose = ParsePose(fields, format, where);
    pose.line = line.number;
    if (format == TrajectoryFormat::kKitti) {
      pose.timestamp = ComputeLineStamp(poses.size(), lines.size(), reading, file);
    }
    if (!poses.empty()) CheckOrder(poses.back(), pose, reading.repeated, where);
    poses.push_back(pose);
  }
  if (poses.empty()) {
    throw InputError(
        fmt::format("{}: has no pose; write lines 'timestamp tx ty tz qx qy qz qw'", file.string()));
  }
  return poses;
}

std::vector<double> ReadStamps(const std::filesystem::path& file) {
  std::vector<double> stamps;
  for (const TextLine& line : ReadTextLines(file)) {
    const std::string where = fmt::format("{}:{}", file.string(), line.number);
    stamps.push_back(ParseNumber(line.text.substr(0, line.text.find_first_of(" \t,")), where));
    if (stamps.size() > 1 && stamps.back() <= stamps[stamps.size() - 2]) {
      throw InputError(fmt::format("{}: stamp {:.6f} does not follow {:.6f}; sort the stamps", where,
                                   stamps.back(), stamps[stamps.size() - 2]));
    }
  }
  if (stamps.empty()) throw InputError(fmt::format("{}: has no stamp; write one a line", file.string()));
  return stamps;
}

}  // namespace armature
