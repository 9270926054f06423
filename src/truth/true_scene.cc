// SPDX-License-Identifier: BSD-3-Clause
#include "truth/true_scene.h"

#include "category/category_lookup.h"

namespace armature {
namespace {

// Of a plane across the optical axis at that depth; nothing behind the camera.
double PixelsPerMetre(const Camera& camera, double depth) { return depth > 0 ? camera.fx / depth : 0; }

}  // namespace

TrueScene::TrueScene(const SequenceTruth& sequence, const std::vector<CategoryModel>& models,
                     const CadLibrary& cad)
    : sequence_(sequence) {
  for (const TrueObject& object : sequence.truth.objects) {
    const CategoryModel& model = LookUpModel(models, object.category);
    objects_.push_back({model.spec, WireframeFromVector(model.mean), cad.FindEdges(object)});
  }
}

std::optional<std::vector<VisibleEdge>> TrueScene::EdgesSeen(size_t object,
                                                             const TimedPose& T_world_camera) const {
  const Eigen::Isometry3d T_camera_world = T_world_camera.pose.inverse();
  if (sequence_.edges) {
    const Eigen::Vector3d centre =
        T_camera_world * sequence_.truth.objects[object].T_world_object.translation();
    return sequence_.edges->Seen(object, T_world_camera.timestamp,
                                 PixelsPerMetre(sequence_.camera, centre.z()));
  }
  if (!objects_[object].wireframe) return std::nullopt;
  return ProjectedEdges(object, T_camera_world);
}

std::vector<VisibleEdge> TrueScene::ProjectedEdges(size_t object,
                                                   const Eigen::Isometry3d& T_camera_world) const {
  const std::vector<TrueObject>& truth = sequence_.truth.objects;
  std::vector<ImageFace> occluders;
  for (size_t i = 0; i < objects_.size(); ++i) {
    if (i == object || !objects_[i].wireframe) continue;
    for (ImageFace& face : ProjectFaces(sequence_.camera, objects_[i].spec, *objects_[i].wireframe,
                                        T_camera_world * truth[i].T_world_object)) {
      occluders.push_back(std::move(face));
    }
  }
  return VisibleEdges(sequence_.camera, objects_[object].spec, *objects_[object].wireframe,
                      T_camera_world * truth[object].T_world_object, occluders);
}

}  // namespace armature
