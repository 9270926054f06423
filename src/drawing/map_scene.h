// SPDX-License-Identifier: BSD-3-Clause
// The map as something to look at: cameras, trajectory, wireframes and CAD models as coloured triangles, so
// that every viewer of meshes shows all of it.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "geometry/triangle_mesh.h"

namespace armature {

struct MapSceneObject {
  std::string id;
  std::string category;
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();  // metres
  Wireframe wireframe;                                               // as estimated, object frame, metres
  TriangleMesh cad;  // the retrieved model, object frame, metres; without triangles: there is none
};

// The world's axes are whatever the map has; `up_world` tells which way is up (unit).
struct MapScene {
  std::vector<Eigen::Isometry3d> T_world_camera;
  std::vector<MapSceneObject> objects;
  Eigen::Vector3d up_world{0, -1, 0};
};

struct SceneMeshOptions {
  double wireframe_thickness = 0.014;  // metres, as all
  double path_thickness = 0.01;
  double camera_depth = 0.12;    // from the centre of a camera's pyramid to its base
  double camera_spacing = 0.25;  // of the drawn cameras, along the path
};

// Pyramids and path of the cameras, wireframes as bars, CAD models. World frame, metres.
TriangleMesh SceneMesh(const MapScene& scene, const SceneMeshOptions& options = {});

inline const ColourBytes kCameraColour{236, 72, 153};  // pink
inline const ColourBytes kPathColour{20, 20, 20};

// A colour for each category of the scene, in shades that differ from object to object.
ColourBytes ObjectColour(const MapScene& scene, size_t object);
// Darker, so that the wireframe stands out against the CAD model.
ColourBytes WireframeColour(const MapScene& scene, size_t object);

// Edges as bars, in the wireframe's frame.
TriangleMesh WireframeMesh(const Wireframe& wireframe, double thickness, const ColourBytes& colour);

// The first camera, and every one that is at least `spacing` further along the path than the one before it.
std::vector<Eigen::Isometry3d> SpacedCameras(const std::vector<Eigen::Isometry3d>& T_world_camera,
                                             double spacing);

}  // namespace armature
