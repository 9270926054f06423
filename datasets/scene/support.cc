// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/scene/support.h"

#include <algorithm>

#include "drawing/ray_scene.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;

// From the object frame (y up, front +z) to a frame with z up and the front at -y.
Isometry3d Upright() { return Isometry3d(Eigen::AngleAxisd(90 * kDegree, Eigen::Vector3d::UnitX())); }

// Those of a chair's wireframe that go around its seat (configs/categories/specs/chair.yaml).
constexpr int kChairEdges = 11, kSeatEdges = 3, kSeatSides = 4;

// Where rays from above meet the seat around its middle: cushions and bent shells are higher than its edges.
Eigen::Vector3d SeatTop(const CadInstance& chair) {
  constexpr double kFromAbove = 0.2, kAside = 0.08, kGap = 0.002;  // metres
  Eigen::Vector3d top = chair.wireframe.midpoints.middleCols(kSeatEdges, kSeatSides).rowwise().mean();
  const RayScene rays({{chair.mesh}});
  const double start = top.y() + kFromAbove;
  for (const double x : {-kAside, 0.0, kAside}) {
    for (const double z : {-kAside, 0.0, kAside}) {
      const RayHit hit = rays.Nearest({top.x() + x, start, top.z() + z}, Eigen::Vector3d(0, -1, 0));
      if (hit.mesh >= 0 && hit.distance < 2 * kFromAbove)
        top.y() = std::max(top.y(), start - hit.distance + kGap);
    }
  }
  return top;
}

}  // namespace

bool IsSupport(const SceneObject& object) {
  const CadInstance& instance = object.instance;
  return instance.category == "table" ||
         (instance.category == "chair" && instance.wireframe.edges() == kChairEdges);
}

Isometry3d FindTop(const SceneObject& object) {
  const Eigen::Vector3d top = object.instance.category == "chair"
                                  ? SeatTop(object.instance)
                                  : Eigen::Vector3d(0, 0.5 * object.instance.size.y(), 0);
  return object.T_world_object * Translation3d(top) * Upright().inverse();
}

Isometry3d StandingOn(const Isometry3d& T_world_surface, const CadInstance& instance) {
  return T_world_surface * Translation3d(0, 0, 0.5 * instance.size.y()) * Upright();
}

}  // namespace armature
