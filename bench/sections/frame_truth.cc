// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sections/frame_truth.h"

#include "base/interrupt.h"
#include "category/category_lookup.h"
#include "truth/sequence_truth.h"
#include "truth/true_scene.h"

namespace armature {
namespace {

bool HasTruth(const std::filesystem::path& folder) {
  for (const char* file : {"groundtruth.txt", "objects_gt.csv", "detections_gt.csv"}) {
    if (!std::filesystem::exists(folder / file)) return false;
  }
  return true;
}

FrameTruth FindTruth(const FrameInput& frame, const GroundTruth& truth, const TrueScene& scene) {
  FrameTruth detections(frame.detections.size());
  const auto camera = FindStamp(truth.T_world_camera, frame.timestamp);
  for (size_t i = 0; i < detections.size() && camera; ++i) {
    const TrueObject* object = truth.FindObject(frame.timestamp, static_cast<int>(i));
    if (!object) continue;
    const TimedPose& T_world_camera = truth.T_world_camera[*camera];
    const auto index = static_cast<size_t>(object - truth.objects.data());
    detections[i] = {object->category, scene.spec(index).symmetry_order,
                     T_world_camera.pose.inverse() * object->T_world_object,
                     scene.EdgesSeen(index, T_world_camera)};
  }
  return detections;
}

}  // namespace

std::vector<FrameTruth> LoadFrameTruth(const std::filesystem::path& folder, const BenchSequence& sequence,
                                       const std::vector<CategoryModel>& models, const CadLibrary& cad) {
  if (!HasTruth(folder)) return {};
  const SequenceTruth truth = LoadSequenceTruth(folder, CollectSpecs(models));
  const TrueScene scene(truth, models, cad);
  std::vector<FrameTruth> frames;
  for (const BenchFrame& frame : sequence.frames) {
    ThrowIfInterrupted();
    frames.push_back(FindTruth(frame.input, truth.truth, scene));
  }
  return frames;
}

}  // namespace armature
