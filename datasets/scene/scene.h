// SPDX-License-Identifier: BSD-3-Clause
// What a scene file says (datasets/README.md). World frame: z up, the floor at z = 0, metres.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "datasets/cad/cad_instance.h"
#include "datasets/render/camera_effects.h"
#include "datasets/render/renderer.h"
#include "datasets/scene/camera_path.h"
#include "datasets/simulation/detection_noise.h"
#include "datasets/simulation/odometry_noise.h"
#include "geometry/camera.h"

namespace armature {

struct Room {
  Eigen::Vector3d size{8, 6, 2.7};  // metres; the room is centred at the world's origin
  Material floor, walls;
  double skirting = 0.08;  // height of the skirting boards, metres; 0: none
  int pictures = 6;        // framed ones on the walls
  int clutter = 8;         // things on the floor along the walls, where nothing else stands
  int table_clutter = 3;   // things on each table, where nothing else stands
};

struct SceneObject {
  std::string id;        // letters, digits, '-' and '_'
  CadInstance instance;  // of the collection
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();
};

// Something that is nobody's object: it makes confusing lines. Mesh frame: z up, origin at the centre of its
// footprint, so that it stands on z = 0.
struct ClutterPiece {
  Mesh mesh;
  Eigen::Isometry3d T_world_mesh = Eigen::Isometry3d::Identity();
  std::string shape;  // one of ClutterShapes()
  std::string id;     // letters, digits, '-' and '_'; empty: it has none
};

struct Scene {
  std::string name;   // letters, digits, '-' and '_': it names a folder
  std::string about;  // one line
  std::uint64_t seed = 1;
  Camera camera;
  double fps = 10;
  int frames = 150;  // of the whole path
  Room room;
  std::vector<SceneObject> objects;
  std::vector<ClutterPiece> clutter;
  std::vector<Lamp> lamps;
  double light_grid = 0.03;  // metres between points where the light is computed
  CameraPath path;
  CameraEffects effects;
  OdometryNoise odometry;
  DetectorNoise detections;
};

// Furniture that no category covers, of the scene's clutter in its order: detectors take it for objects.
std::vector<ClutterPiece> Distractors(const Scene& scene);

}  // namespace armature
