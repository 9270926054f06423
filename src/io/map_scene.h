// SPDX-License-Identifier: BSD-3-Clause
// The map as something to look at: cameras, trajectory, wireframes and CAD models as coloured triangles, so
// that every viewer of meshes shows all of it.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "geometry/triangle_mesh.h"

namespace armature {

struct SceneObject {
  std::string category;
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();  // metres
  Wireframe wireframe;                                               // as estimated, object frame, metres
  TriangleMesh cad;  // the retrieved model, object frame, metres; without triangles: there is none
};

// The world's axes are whatever the map has; `up_world` tells which way is up (unit).
struct MapScene {
  std::vector<Eigen::Isometry3d> T_world_camera;
  std::vector<SceneObject> objects;
  Eigen::Vector3d up_world{0, -1, 0};
};

}  // namespace armature
