// SPDX-License-Identifier: BSD-3-Clause
// Where the surfaces of a scene make lines in pictures: edges between faces, outlines, and patterns.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "drawing/ray_scene.h"

namespace armature {

struct SurfaceLine {
  Eigen::Vector3d p1, p2;            // world, metres
  Eigen::Vector3d normal1, normal2;  // of the two faces, outwards; equal: on a face, or where one ends
  bool is_sharp = true;              // else it is seen only as an outline: one face towards the camera
  double contrast = 0;               // standard normal; the same in all pictures
};

// Edges of all parts, those of smooth curves as outlines; lines of patterns (joints of floors, grain, prints)
// drawn at random on the faces, so many a square metre of wood. The same for the same seed.
std::vector<SurfaceLine> FindSurfaceLines(const std::vector<PlacedMesh>& meshes, double patterns_per_m2,
                                          std::uint64_t seed);

}  // namespace armature
