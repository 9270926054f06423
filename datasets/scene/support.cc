// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/scene/support.h"

#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;

// From the object frame (y up, front +z) to a frame with z up and the front at -y.
Isometry3d Upright() { return Isometry3d(Eigen::AngleAxisd(90 * kDegree, Eigen::Vector3d::UnitX())); }

}  // namespace

bool IsSupport(const SceneObject& object) { return object.instance.category == "table"; }

Isometry3d FindTop(const SceneObject& object) {
  return object.T_world_object * Translation3d(0, 0.5 * object.instance.size.y(), 0) * Upright().inverse();
}

Isometry3d StandingOn(const Isometry3d& T_world_surface, const CadInstance& instance) {
  return T_world_surface * Translation3d(0, 0, 0.5 * instance.size.y()) * Upright();
}

}  // namespace armature
