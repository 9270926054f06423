// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/seen_objects.h"

#include <algorithm>
#include <cmath>

namespace armature {

SeenObjects SeeObjects(const MapGraph& graph, size_t camera, const Camera& intrinsics) {
  SeenObjects seen;
  const Eigen::Isometry3d T_camera_world = graph.T_world_camera[camera].inverse();
  for (const GraphObject& object : graph.objects) {
    const Eigen::Isometry3d at = SeenAtUnitSize(T_camera_world * object.T_world_object, object.log_size);
    seen.objects.push_back({{at, object.coefficients},
                            WireframeFromCoefficients(*object.model, object.coefficients),
                            std::exp(object.log_size)});
    seen.faces.push_back(ProjectFaces(intrinsics, object.model->spec, seen.objects.back().wireframe, at));
    for (ImageFace& face : seen.faces.back()) face.inverse_depth /= seen.objects.back().size;
  }
  return seen;
}

std::vector<ImageFace> Occluders(const SeenObjects& seen, size_t object, const ObjectView& view) {
  std::vector<ImageFace> others = view.occluders;
  for (size_t o = 0; o < seen.faces.size(); ++o) {
    if (o != object) others.insert(others.end(), seen.faces[o].begin(), seen.faces[o].end());
  }
  for (ImageFace& face : others) face.inverse_depth *= seen.objects[object].size;
  return others;
}

ProjectedWireframe ProjectWhole(const SeenObject& object, const Camera& camera) {
  constexpr Box kEverywhere{-1e5, -1e5, 2e5, 2e5};
  ProjectedWireframe projected;
  ProjectEdges(camera, object.wireframe, object.at.T_camera_object, kEverywhere, projected);
  return projected;
}

namespace {

constexpr double kLikelyHidden = 0.5;  // by another detection that goes on beyond the side

bool IsHidden(const ExtremePoint& extreme, const Eigen::Vector2d& pixel,
              const std::vector<ImageFace>& occluders) {
  return std::any_of(occluders.begin(), occluders.end(),
                     [&](const ImageFace& face) { return face.Hides(pixel, extreme.inverse_z); });
}

}  // namespace

BoxSides SidesSeen(const SeenObject& object, const ObjectView& view, const std::vector<ImageFace>& occluders,
                   const BoxOptions& options) {
  const Box& box = view.detection.box;
  BoxSides sides = SidesAtImageBorder(box, *view.camera);
  const ProjectedWireframe projected = ProjectWhole(object, *view.camera);
  const std::array<ExtremePoint, 4> extremes = Extremes(projected);
  const std::array<double, 4> beyond = {box.left() - extremes[0].pixel, box.top() - extremes[1].pixel,
                                        extremes[2].pixel - box.right(), extremes[3].pixel - box.bottom()};
  const auto [sigma_x, sigma_y] = SideSigmas(box, options);
  for (size_t side = 0; side < 4; ++side) {
    if (extremes[side].edge < 0 || beyond[side] <= 2 * (side % 2 == 0 ? sigma_x : sigma_y)) continue;
    const ProjectedEdge& edge = projected.edges[static_cast<size_t>(extremes[side].edge)];
    const bool is_second_end = extremes[side].s > 0.5 * (edge.s1 + edge.s2);
    const Eigen::Vector2d& pixel = is_second_end ? edge.line.p2 : edge.line.p1;
    if (view.hidden_probability[side] > kLikelyHidden || IsHidden(extremes[side], pixel, occluders))
      sides[side] = BoxSide::kOpen;
  }
  return sides;
}

ProjectedWireframe ProjectSeen(const SeenObject& object, const ObjectView& view, const BoxSides& sides,
                               const std::vector<ImageFace>& occluders) {
  ProjectedWireframe projected;
  ProjectWireframe(*view.camera, view.model->spec, object.wireframe, object.at.T_camera_object,
                   ClipBox(view.detection.box, sides, *view.camera), occluders, projected);
  return projected;
}

}  // namespace armature
