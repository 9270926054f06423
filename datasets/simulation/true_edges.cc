// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulation/true_edges.h"

#include <algorithm>
#include <cmath>

#include "association/projection.h"

namespace armature {
namespace {

constexpr double kInside = 0.06;     // metres that an edge may lie below its object's surface
constexpr double kTolerance = 0.01;  // metres, against other things
constexpr double kStep = 4;          // pixels between two rays

bool IsSeen(const RayScene& rays, int object, const Eigen::Vector3d& camera_world,
            const Eigen::Vector3d& point) {
  const Eigen::Vector3d to_point = point - camera_world;
  const RayHit hit = rays.Nearest(camera_world, to_point.normalized());
  if (hit.mesh < 0) return true;
  const double behind = to_point.norm() - hit.distance;
  return behind <= (hit.object == object ? kInside : kTolerance);
}

}  // namespace

std::vector<TrueEdge> FindTrueEdges(const RayScene& rays, int object, const Wireframe& wireframe,
                                    const Eigen::Isometry3d& T_world_object, const Camera& camera,
                                    const Eigen::Isometry3d& T_world_camera) {
  const Box image{-0.5, -0.5, static_cast<double>(camera.width), static_cast<double>(camera.height)};
  ProjectedWireframe projected;
  ProjectEdges(camera, wireframe, T_world_camera.inverse() * T_world_object, image, projected);
  std::vector<TrueEdge> edges;
  for (int e = 0; e < wireframe.edges(); ++e) {
    const ProjectedEdge& edge = projected.edges[static_cast<size_t>(e)];
    if (edge.length <= 0) continue;
    const int count = std::max(1, static_cast<int>(std::lround(edge.length / kStep)));
    int seen = 0;
    for (int i = 0; i < count; ++i) {
      // Even steps in the image: 1/z is linear along the projected edge, so the point is where the pixel's
      // ray has that depth.
      const double t = (i + 0.5) / count;
      const Eigen::Vector2d pixel = edge.line.p1 + t * (edge.line.p2 - edge.line.p1);
      const double z = 1 / (edge.inverse_z1 + t * (edge.inverse_z2 - edge.inverse_z1));
      if (IsSeen(rays, object, T_world_camera.translation(), T_world_camera * (z * camera.Ray(pixel))))
        ++seen;
    }
    edges.push_back({e, edge.line, static_cast<double>(seen) / count});
  }
  return edges;
}

}  // namespace armature
