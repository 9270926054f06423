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
constexpr double kLengthTolerance = 0.02;  // of a quaternion: real files have some of 1.004

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

constexpr size_t kMostFields = 1000;  // EuRoC's rows have 17

// At commas where the line has any, else at blanks.
Fields Split(const std::string& line, const std::string& where) {
  const auto commas = static_cast<size_t>(std::count(line.begin(), line.end(), ','));
  if (commas > kMostFields) {
    throw InputError(
        fmt::format("{}: {} commas are no pose; write 'timestamp tx ty tz qx qy qz qw'", where, commas));
  }
  if (commas > 0) return {SplitFields(line), true};
  return {SplitWords(line), false};
}

bool IsNumber(const std::string& text) {
  try {
    ParseNumber(text, "");
    return true;
  } catch (const InputError&) {
    return false;
  }
}

// Names of columns where the first pose should be.
void CheckIsNoHeader(const Fields& first, const std::string& where) {
  if (std::any_of(first.texts.begin(), first.texts.end(), IsNumber)) return;
  throw InputError(fmt::format("{}: {} is a header line; put a '#' before it", where,
                               Quoted(fmt::format("{}", fmt::join(first.texts, " ")))));
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
  if (std::abs(q.norm() - 1) > kLengthTolerance) {
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

void CheckOrder(const TimedPose& earlier, const TimedPose& later, const std::string& where) {
  if (later.timestamp >= earlier.timestamp) return;
  throw InputError(fmt::format("{}: stamp {:.6f} is before {:.6f} of line {}; sort the lines by stamp", where,
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

std::vector<TimedPose> ReadTumTrajectory(const std::filesystem::path& file) {
  return ReadTrajectory(file, {.format = TrajectoryFormat::kTum});
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

TrajectoryFile ReadTrajectoryFile(const std::filesystem::path& file, const TrajectoryReading& reading) {
  const std::vector<TextLine> lines = ReadTextLines(file);
  TrajectoryFormat format = reading.format;
  TrajectoryFile read;
  for (size_t i = 0; i < lines.size(); ++i) {
    const std::string where = fmt::format("{}:{}", file.string(), lines[i].number);
    const Fields fields = Split(lines[i].text, where);
    if (read.poses.empty()) CheckIsNoHeader(fields, where);
    if (format == TrajectoryFormat::kAuto) format = DetectFormat(fields, where);
    CheckLayout(fields, GetLayout(format), where);
    TimedPose pose = ParsePose(fields, format, where);
    pose.line = lines[i].number;
    if (format == TrajectoryFormat::kKitti) {
      pose.timestamp = ComputeLineStamp(i, lines.size(), reading, file);
    }
    if (!read.poses.empty()) {
      CheckOrder(read.poses.back(), pose, where);
      const bool is_repeated = pose.timestamp == read.poses.back().timestamp;
      if (is_repeated && reading.repeated == RepeatedStamps::kFirstKept) {
        ++read.repeated;
        continue;
      }
    }
    read.poses.push_back(pose);
  }
  read.is_numbered = format == TrajectoryFormat::kKitti && reading.stamps.empty();
  if (!read.poses.empty()) return read;
  throw InputError(
      fmt::format("{}: has no pose; write lines 'timestamp tx ty tz qx qy qz qw'", file.string()));
}

std::string DescribeRepeatedStamps(const std::filesystem::path& file, const TrajectoryFile& read) {
  if (read.repeated == 0) return "";
  return fmt::format("{}: {} of {} poses have the stamp of the one before; the first of each stamp is kept",
                     file.string(), read.repeated, read.repeated + read.poses.size());
}

std::vector<TimedPose> ReadTrajectory(const std::filesystem::path& file, const TrajectoryReading& reading) {
  return ReadTrajectoryFile(file, reading).poses;
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
