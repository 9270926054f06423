// SPDX-License-Identifier: BSD-3-Clause
// What a picture of a map is made of.
#pragma once

#include <vector>

#include "drawing/map_view.h"
#include "drawing/ray_scene.h"

namespace armature {

// Ground, the first, and CAD models, which cast shadows. World frame, metres.
std::vector<PlacedMesh> MapBodies(const MapScene& scene, const MapGround& ground);

// Balls for the sampled cameras and dots along the trajectory.
std::vector<PlacedMesh> MapPath(const MapScene& scene);

// The objects' wireframes as bars.
std::vector<PlacedMesh> MapWireframes(const MapScene& scene);

// Points along the path, equally far from each other.
std::vector<Eigen::Vector3d> PathDots(const std::vector<Eigen::Isometry3d>& T_world_camera, double spacing);

}  // namespace armature
