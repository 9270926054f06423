// SPDX-License-Identifier: BSD-3-Clause
#include "io/sequence.h"

#include <fmt/format.h>

#include <utility>

#include "base/console.h"
#include "base/errors.h"
#include "io/trajectory_formats.h"

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

std::vector<double> CollectStamps(const std::vector<ImageEntry>& images) {
  std::vector<double> stamps;
  stamps.reserve(images.size());
  for (const ImageEntry& image : images) stamps.push_back(image.timestamp);
  return stamps;
}

void LoadOdometry(const std::filesystem::path& file, const OdometryOptions& options, Sequence* sequence) {
  const std::vector<double> stamps = CollectStamps(sequence->images);
  if (std::filesystem::exists(file)) sequence->odometry = ReadTrajectory(file, {.stamps = stamps});
  OdometryAtImages at_images = PosesAtImages(sequence->odometry, stamps, options);
  sequence->T_odom_camera = std::move(at_images.T_odom_camera);
  sequence->coverage = at_images.coverage;
  if (sequence->odometry.empty() || sequence->coverage.images_with_pose > 0) return;
  throw InputError(
      fmt::format("{}:{}: no pose is within {:g} ms of an image, and no two at most {:g} s apart are around "
                  "one; use the stamps of rgb.txt",
                  file.string(), sequence->odometry.front().line, 1e3 * options.tolerance, options.max_gap));
}

}  // namespace

Sequence LoadSequence(const std::filesystem::path& folder, const std::vector<std::string>& categories,
                      const OdometryOptions& odometry) {
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
  LoadOdometry(folder / "odometry.txt", odometry, &sequence);
  Detail(fmt::format("read {}: {} images, {} poses of odometry", folder.string(), sequence.images.size(),
                     sequence.odometry.size()));
  return sequence;
}

std::string NameDraw(const std::string& scene, int draw) {
  return draw == 1 ? scene : fmt::format("{}-draw{}", scene, draw);
}

}  // namespace armature
