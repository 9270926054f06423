// SPDX-License-Identifier: BSD-3-Clause
#include "io/sequence.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/errors.h"

namespace armature {
namespace {

void CheckFolder(const std::filesystem::path& folder) {
  std::error_code ignored;
  if (std::filesystem::is_directory(folder, ignored)) return;
  const bool exists = std::filesystem::exists(folder, ignored);
  throw InputError(
      fmt::format("{}: {}; name a sequence folder with sequence.yaml, rgb.txt and detections.csv",
                  folder.string(), exists ? "is not a folder" : "does not exist"));
}

// The odometry's pose at every image's stamp.
std::vector<std::optional<Eigen::Isometry3d>> PosesOfImages(const std::vector<ImageEntry>& images,
                                                            const std::vector<TimedPose>& odometry) {
  std::vector<std::optional<Eigen::Isometry3d>> poses(images.size());
  for (size_t i = 0; i < images.size(); ++i) {
    const std::optional<size_t> index = IndexOfStamp(odometry, images[i].timestamp);
    if (index) poses[i] = odometry[*index].pose;
  }
  return poses;
}

void LoadOdometry(const std::filesystem::path& file, Sequence* sequence) {
  if (std::filesystem::exists(file)) sequence->odometry = ReadTumTrajectory(file);
  sequence->T_odom_camera = PosesOfImages(sequence->images, sequence->odometry);
  const bool matches = std::any_of(sequence->T_odom_camera.begin(), sequence->T_odom_camera.end(),
                                   [](const auto& pose) { return pose.has_value(); });
  if (sequence->odometry.empty() || matches) return;
  throw InputError(fmt::format("{}:{}: no pose is within 1 ms of an image; use the stamps of rgb.txt",
                               file.string(), sequence->odometry.front().line));
}

}  // namespace

Sequence LoadSequence(const std::filesystem::path& folder, const std::vector<std::string>& categories) {
  CheckFolder(folder);
  const SequenceSettings settings = ReadSequenceSettings(folder / "sequence.yaml");
  Sequence sequence;
  sequence.name = settings.name;
  sequence.fps = settings.fps;
  sequence.camera = settings.camera;
  sequence.up = settings.up;
  sequence.odometry_metric = settings.odometry_metric;
  sequence.folder = folder;
  sequence.images = ReadImageList(folder / "rgb.txt");
  sequence.detections =
      ReadDetections(folder / "detections.csv", sequence.images, sequence.camera, categories);
  LoadOdometry(folder / "odometry.txt", &sequence);
  return sequence;
}

}  // namespace armature
