// SPDX-License-Identifier: BSD-3-Clause
#include "eval/true_scene.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/errors.h"

namespace armature {

const CategorySpec& SpecOf(const std::vector<CategorySpec>& specs, const std::string& category) {
  const auto found = std::find_if(specs.begin(), specs.end(),
                                  [&](const CategorySpec& spec) { return spec.name == category; });
  if (found == specs.end()) {
    throw InputError(
        fmt::format("no category '{}' among the category models; add its file, or name the folder that "
                    "has it with --categories",
                    category));
  }
  return *found;
}

TrueScene::TrueScene(const Camera& camera, const GroundTruth& truth, const std::vector<CategorySpec>& specs,
                     const CadLibrary& cad)
    : camera_(camera), truth_(truth) {
  for (const TrueObject& object : truth.objects) {
    objects_.push_back({SpecOf(specs, object.category), cad.EdgesOf(object)});
  }
}

std::optional<std::vector<VisibleEdge>> TrueScene::EdgesSeen(size_t object,
                                                             const Eigen::Isometry3d& T_world_camera) const {
  if (!objects_[object].wireframe) return std::nullopt;
  const Eigen::Isometry3d T_camera_world = T_world_camera.inverse();
  std::vector<ImageFace> occluders;
  for (size_t i = 0; i < objects_.size(); ++i) {
    if (i == object || !objects_[i].wireframe) continue;
    for (ImageFace& face : ProjectFaces(camera_, objects_[i].spec, *objects_[i].wireframe,
                                        T_camera_world * truth_.objects[i].T_world_object)) {
      occluders.push_back(std::move(face));
    }
  }
  return VisibleEdges(camera_, objects_[object].spec, *objects_[object].wireframe,
                      T_camera_world * truth_.objects[object].T_world_object, occluders);
}

}  // namespace armature
