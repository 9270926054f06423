// SPDX-License-Identifier: BSD-3-Clause
#include "eval/budget/true_odometry.h"

#include <fmt/format.h>

#include <sstream>

#include "base/console.h"
#include "base/errors.h"
#include "base/text.h"
#include "eval/trajectories/trajectory_alignment.h"
#include "io/sequence.h"
#include "io/yaml_support.h"
#include "truth/ground_truth.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

constexpr double kPairTolerance = 0.01;  // seconds, as trajectories are compared

std::vector<TimedPose> ReadOdometry(const fs::path& sequence) {
  return ReadTrajectory(sequence / "odometry.txt", {.stamps = ReadStamps(sequence / "rgb.txt")});
}

std::vector<PosePair> PairOdometry(const fs::path& sequence, const std::vector<TimedPose>& odometry,
                                   const std::vector<TimedPose>& truth) {
  std::vector<PosePair> pairs = PairPoses(odometry, truth, kPairTolerance);
  if (!pairs.empty()) return pairs;
  throw InputError(
      fmt::format("{}: no pose is at a time of groundtruth.txt; the stamps of both are seconds "
                  "since the same moment",
                  (sequence / "odometry.txt").string()));
}

// Keys that are not known here stay; comments go.
std::string MetricSettings(const fs::path& file) {
  ReadSequenceSettings(file);  // throws where it is malformed
  YAML::Node settings = YAML::Load(ReadTextFile(file));
  settings["odometry_metric"] = true;
  std::ostringstream text;
  text << settings << "\n";
  return text.str();
}

SubstitutedFiles MetricOdometry(const fs::path& sequence, const std::vector<TimedPose>& poses,
                                const std::string& about) {
  std::string text = "# T_odom_camera, metres: " + about + "\n# timestamp tx ty tz qx qy qz qw\n";
  for (const TimedPose& pose : poses) text += TumLine(pose) + "\n";
  return {{"odometry.txt", text}, {"sequence.yaml", MetricSettings(sequence / "sequence.yaml")}};
}

}  // namespace

SubstitutedFiles ScaleOdometry(const fs::path& sequence) {
  std::vector<TimedPose> odometry = ReadOdometry(sequence);
  const std::optional<double> scale =
      PathScale(PairOdometry(sequence, odometry, LoadTrueTrajectory(sequence)));
  if (!scale) {
    Note(
        fmt::format("{}: the camera hardly moves, so that there is no true scale of the odometry: it is left "
                    "as it is",
                    sequence.string()));
    return {};
  }
  for (TimedPose& pose : odometry) pose.pose.translation() *= *scale;
  return MetricOdometry(sequence, odometry, fmt::format("{:.9g} times the given one", *scale));
}

SubstitutedFiles ReplaceOdometry(const fs::path& sequence) {
  std::vector<TimedPose> cameras = LoadTrueTrajectory(sequence);
  Eigen::Isometry3d T_odom_world = cameras.front().pose.inverse();
  if (fs::exists(sequence / "odometry.txt")) {
    const PosePair first = PairOdometry(sequence, ReadOdometry(sequence), cameras).front();
    T_odom_world = first.estimate * first.truth.inverse();
  }
  for (TimedPose& camera : cameras) camera.pose = T_odom_world * camera.pose;
  return MetricOdometry(sequence, cameras, "the true cameras");
}

}  // namespace armature
