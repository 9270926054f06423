// SPDX-License-Identifier: BSD-3-Clause
// Where an object's edges are in a picture, and how much of them is seen.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "category/category_model.h"
#include "drawing/ray_scene.h"
#include "geometry/camera.h"
#include "geometry/segment.h"

namespace armature {

struct TrueEdge {
  int edge = 0;        // its index in the category
  Segment line;        // pixels: its part inside the image, in the edge's sense
  double visible = 0;  // share of that part that nothing hides, 0..1
};

// The edges that are partly in the image. A point of an edge is seen when the ray to it meets nothing before
// it but the object's own surface at most 6 cm in front of it: edges run inside of legs and posts.
std::vector<TrueEdge> FindTrueEdges(const RayScene& rays, int object, const Wireframe& wireframe,
                                    const Eigen::Isometry3d& T_world_object, const Camera& camera,
                                    const Eigen::Isometry3d& T_world_camera);

}  // namespace armature
