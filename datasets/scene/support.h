// SPDX-License-Identifier: BSD-3-Clause
// What stands on what.
#pragma once

#include "datasets/scene/scene.h"

namespace armature {

// Whether things can stand on it: tables, and chairs whose seat is annotated.
bool IsSupport(const SceneObject& object);

// The frame in the middle of an object's upper side, of a chair's seat: z up, x the object's x, y the
// object's -z.
Eigen::Isometry3d FindTop(const SceneObject& object);

// T_world_object of an instance that stands on the frame's x-y plane, above its origin, its front at -y.
Eigen::Isometry3d StandingOn(const Eigen::Isometry3d& T_world_surface, const CadInstance& instance);

}  // namespace armature
