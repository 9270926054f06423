// SPDX-License-Identifier: BSD-3-Clause
#include "eval/detections/true_boxes.h"

#include "association/projection.h"
#include "category/category_lookup.h"
#include "truth/visible_edges.h"

namespace armature {
namespace {

Wireframe ScaledTo(const Eigen::Vector3d& size, Wireframe wireframe) {
  Eigen::AlignedBox3d around;
  for (int edge = 0; edge < wireframe.edges(); ++edge) {
    for (const int end : {0, 1}) around.extend(wireframe.End(edge, end));
  }
  const Eigen::Array3d scale = size.array() / around.sizes().array().max(1e-6);
  wireframe.midpoints =
      (scale.matrix().asDiagonal() * (wireframe.midpoints.colwise() - around.center())).eval();
  wireframe.directions = (scale.matrix().asDiagonal() * wireframe.directions).eval();
  return wireframe;
}

// The image with as much around it on each side.
Camera Widened(Camera camera) {
  camera.cx += camera.width;
  camera.cy += camera.height;
  camera.width *= 3;
  camera.height *= 3;
  return camera;
}

double VisibleLength(const std::vector<VisibleEdge>& edges) {
  double length = 0;
  for (const VisibleEdge& edge : edges) length += edge.visible_length();
  return length;
}

Box AroundSamples(const std::vector<VisibleEdge>& edges) {
  Eigen::AlignedBox2d around;
  for (const VisibleEdge& edge : edges) {
    for (const Eigen::Vector2d& sample : edge.samples) around.extend(sample);
  }
  if (around.isEmpty()) return {};
  return {around.min().x(), around.min().y(), around.sizes().x(), around.sizes().y()};
}

Box AroundLines(const std::vector<VisibleEdge>& edges) {
  Eigen::AlignedBox2d around;
  for (const VisibleEdge& edge : edges) {
    if (edge.in_image) around.extend(edge.line.p1).extend(edge.line.p2);
  }
  if (around.isEmpty()) return {};
  return {around.min().x(), around.min().y(), around.sizes().x(), around.sizes().y()};
}

}  // namespace

TrueWireframes::TrueWireframes(const std::vector<TrueObject>& objects,
                               const std::vector<CategoryModel>& models) {
  for (const TrueObject& object : objects) {
    const CategoryModel& model = LookUpModel(models, object.category);
    objects_.push_back(
        {model.spec, ScaledTo(object.size, WireframeFromVector(model.mean)), object.T_world_object});
  }
}

std::vector<TrueBox> TrueWireframes::Seen(const Camera& camera,
                                          const Eigen::Isometry3d& T_world_camera) const {
  const Eigen::Isometry3d T_camera_world = T_world_camera.inverse();
  std::vector<std::vector<ImageFace>> faces;
  for (const Object& object : objects_) {
    faces.push_back(
        ProjectFaces(camera, object.spec, object.wireframe, T_camera_world * object.T_world_object));
  }
  std::vector<TrueBox> seen;
  for (size_t i = 0; i < objects_.size(); ++i) {
    const Object& object = objects_[i];
    const Eigen::Isometry3d T_camera_object = T_camera_world * object.T_world_object;
    std::vector<ImageFace> occluders;
    for (size_t other = 0; other < faces.size(); ++other) {
      if (other != i) occluders.insert(occluders.end(), faces[other].begin(), faces[other].end());
    }
    const auto edges = VisibleEdges(camera, object.spec, object.wireframe, T_camera_object, occluders);
    const double length = VisibleLength(edges);
    if (length <= 0) continue;
    const double alone =
        VisibleLength(VisibleEdges(Widened(camera), object.spec, object.wireframe, T_camera_object, {}));
    seen.push_back({i, AroundSamples(edges), AroundLines(edges), length / alone});
  }
  return seen;
}

}  // namespace armature
