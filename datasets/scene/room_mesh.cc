// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/scene/room_mesh.h"

#include "datasets/cad/solids.h"
#include "datasets/scene/clutter.h"
#include "datasets/scene/scattered_clutter.h"
#include "datasets/scene/walls.h"
#include "geometry/random.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

Material Plain(const Colour& colour, double gloss = 0) {
  return {Texture::kPlain, colour, 0.95 * colour, 0.5, gloss, 0};
}

// Single sheets: nobody sees them from outside.
Mesh Shell(const Room& room) {
  const Eigen::AngleAxisd downwards(180 * kDegree, Vector3d::UnitX());
  Mesh mesh;
  mesh.parts.push_back(Sheet(Isometry3d::Identity(), room.size.head<2>(), room.floor));
  mesh.parts.push_back(Sheet(Translation3d(0, 0, room.size.z()) * Isometry3d(downwards), room.size.head<2>(),
                             Plain({0.93, 0.93, 0.92})));
  unsigned number = 0;
  for (const Wall& wall : MakeWalls(room)) {
    Material material = room.walls;
    material.seed += number++;
    mesh.parts.push_back(Sheet(wall.T_world_wall * Translation3d(0, 0.5 * wall.height, 0),
                               {wall.width, wall.height}, material));
  }
  return mesh;
}

Mesh SkirtingBoards(const Room& room) {
  constexpr double kThickness = 0.015;
  Mesh mesh;
  if (room.skirting <= 0) return mesh;
  for (const Wall& wall : MakeWalls(room)) {
    mesh.parts.push_back(Block(wall.T_world_wall * Translation3d(0, 0.5 * room.skirting, 0.5 * kThickness),
                               {wall.width, room.skirting, kThickness}, Plain({0.9, 0.89, 0.86}, 0.3)));
  }
  return mesh;
}

// Above the lit rectangle, a little larger, and two rods that it hangs from.
void AddHousing(const Lamp& lamp, double ceiling, Mesh* mesh) {
  constexpr double kRim = 0.02, kGap = 0.004, kRod = 0.012;
  const Material metal = Plain({0.7, 0.7, 0.7}, 0.4);
  const double bottom = lamp.centre.z() + kGap, top = std::min(bottom + 0.05, ceiling - kGap);
  if (top <= bottom) return;
  const Vector2d half = 0.5 * lamp.size + Vector2d(kRim, kRim), centre = lamp.centre.head<2>();
  const auto box = [&](const Vector2d& at, const Vector2d& reach, double low, double high) {
    mesh->parts.push_back(Block({at.x() - reach.x(), at.y() - reach.y(), low},
                                {at.x() + reach.x(), at.y() + reach.y(), high}, metal));
  };
  box(centre, half, bottom, top);
  if (ceiling - top < 0.02) return;
  const bool is_long_in_x = lamp.size.x() >= lamp.size.y();
  const Vector2d apart = 0.35 * (is_long_in_x ? Vector2d(lamp.size.x(), 0) : Vector2d(0, lamp.size.y()));
  for (const double side : {-1.0, 1.0}) {
    box(centre + side * apart, Vector2d(0.5 * kRod, 0.5 * kRod), top, ceiling);
  }
}

Mesh Housings(const Scene& scene) {
  Mesh mesh;
  for (const Lamp& lamp : scene.lamps) AddHousing(lamp, scene.room.size.z(), &mesh);
  return mesh;
}

}  // namespace

std::vector<ClutterPiece> Distractors(const Scene& scene) {
  std::vector<ClutterPiece> distractors;
  for (const ClutterPiece& piece : scene.clutter) {
    if (IsDistractor(piece.shape)) distractors.push_back(piece);
  }
  return distractors;
}

std::vector<PlacedMesh> SceneMeshes(const Scene& scene) {
  std::vector<PlacedMesh> meshes;
  int object = kRoom;
  for (const SceneObject& placed : scene.objects) {
    meshes.push_back({placed.instance.mesh, placed.T_world_object, ++object});
  }
  Random decoration(scene.seed + 77);
  for (const Mesh& mesh : {Shell(scene.room), SkirtingBoards(scene.room),
                           WallDecoration(scene.room, decoration), Housings(scene)}) {
    if (!mesh.parts.empty()) meshes.push_back({mesh});
  }
  for (const ClutterPiece& piece : scene.clutter) {
    const bool is_numbered = IsDistractor(piece.shape);
    meshes.push_back({piece.mesh, piece.T_world_mesh, is_numbered ? ++object : kRoom});
  }
  for (const ClutterPiece& piece : ScatteredClutter(scene))
    meshes.push_back({piece.mesh, piece.T_world_mesh});
  return meshes;
}

}  // namespace armature
