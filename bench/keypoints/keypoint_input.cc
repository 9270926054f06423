// SPDX-License-Identifier: BSD-3-Clause
#include "bench/keypoints/keypoint_input.h"

#include <optional>
#include <utility>

#include "association/box_constraints.h"
#include "bench/keypoints/drawn_keypoints.h"
#include "bench/keypoints/heat_maps.h"
#include "bench/keypoints/keypoint_resection.h"

namespace armature {
namespace {

constexpr std::uint64_t kSeed = 1;

std::optional<Eigen::Vector3d> EstimateUp(const BenchSequence& sequence, const FrameInput& input) {
  if (!sequence.up_odom || !input.T_odom_camera) return std::nullopt;
  return (input.T_odom_camera->linear().transpose() * *sequence.up_odom).normalized();
}

KeypointInput MakeInput(const Detection& detection, const KeypointCategory& category, const Camera& camera,
                        const std::optional<Eigen::Vector3d>& up_camera, Random& random) {
  KeypointInput input;
  input.view.camera = &camera;
  input.view.model = &category.model;
  input.view.detection = detection;
  input.view.detection.box = UndistortBox(camera, detection.box);
  input.view.sides = SidesAtImageBorder(input.view.detection.box, camera);
  input.view.up_camera = up_camera;
  input.keypoints = &category.keypoints;
  input.crop = CropAround(detection.box);
  input.maps = DrawHeatMaps(DrawnKeypoints(input.view, category.keypoints, random), input.crop);
  return input;
}

}  // namespace

KeypointCategories MakeKeypointCategories(std::vector<CategoryModel> models) {
  KeypointCategories categories;
  for (CategoryModel& model : models) {
    const std::string name = model.spec.name;
    std::vector<ShapePoint> keypoints = MakeKeypoints(model);
    categories.emplace(name, KeypointCategory{std::move(model), std::move(keypoints)});
  }
  return categories;
}

KeypointInputs MakeKeypointInputs(const BenchSequence& sequence, const KeypointCategories& categories) {
  KeypointInputs inputs;
  std::uint64_t stream = 0;
  for (const BenchFrame& frame : sequence.frames) {
    const std::optional<Eigen::Vector3d> up_camera = EstimateUp(sequence, frame.input);
    std::vector<KeypointInput>& of_frame = inputs[&frame];
    for (const Detection& detection : frame.input.detections) {
      Random random(StreamSeed(kSeed, stream++));
      of_frame.push_back(
          MakeInput(detection, categories.at(detection.category), sequence.camera, up_camera, random));
    }
  }
  return inputs;
}

}  // namespace armature
