// SPDX-License-Identifier: BSD-3-Clause
#include "eval/detections/eval_detections.h"

#include <fmt/format.h>

#include "base/errors.h"
#include "category/category_lookup.h"
#include "cli/configuration.h"
#include "eval/detections/detection_evaluation.h"
#include "eval/detections/detection_tables.h"
#include "io/sequence.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

void CheckIsSequence(const fs::path& folder) {
  if (fs::exists(folder / "sequence.yaml")) return;
  throw InputError(fmt::format(
      "{}: has no sequence.yaml; the table '{}' is of sequence folders with their ground truth, not of runs",
      folder.string(), kDetectionTableName));
}

std::vector<DetectedFrame> ReadFrames(const fs::path& folder, const fs::path& file, const Camera& camera,
                                      const std::vector<std::string>& categories) {
  const std::vector<ImageEntry> images = ReadImageList(folder / "rgb.txt");
  auto detections =
      ReadDetections(file.empty() ? folder / "detections.csv" : file, images, camera, categories);
  std::vector<DetectedFrame> frames;
  for (size_t i = 0; i < images.size(); ++i) {
    DetectedFrame frame{images[i].timestamp, std::move(detections[i])};
    // Truth is without distortion.
    for (Detection& detection : frame.detections) {
      if (camera.IsDistorted()) detection.box = UndistortBox(camera, detection.box);
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace

Evaluation MakeDetectionTables(const std::vector<fs::path>& sequences, const fs::path& file,
                               const std::vector<CategoryModel>& models) {
  if (!file.empty() && sequences.size() != 1) {
    throw InputError(
        fmt::format("--detections: is of one sequence, and {} are given; name one", sequences.size()));
  }
  Evaluation made;
  for (const fs::path& folder : sequences) {
    CheckIsSequence(folder);
    const SequenceTruth truth = LoadSequenceTruth(folder, CollectSpecs(models));
    const auto frames = ReadFrames(folder, file, truth.camera, CategoryNames(models));
    std::vector<DetectionRecord> records = EvaluateDetections(frames, truth, models);
    for (Table& table : DetectionTables(records)) made.tables.push_back(std::move(table));
    made.Append({.records = {.detections = std::move(records)}});
  }
  return made;
}

}  // namespace armature
