// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/scene/scattered_clutter.h"

#include <algorithm>

#include "datasets/scene/clutter.h"
#include "datasets/scene/solid.h"
#include "datasets/scene/support.h"
#include "datasets/scene/walls.h"
#include "geometry/random.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

constexpr int kAttempts = 60;            // a piece
constexpr double kCameraDistance = 0.3;  // metres
constexpr double kAround = 0.03;         // metres between pieces and anything else

// What takes space already.
struct Taken {
  std::vector<OrientedBox> boxes;
  std::vector<Vector3d> cameras;
};

Taken TakenBy(const Scene& scene) {
  Taken taken;
  for (const SceneObject& object : scene.objects) {
    taken.boxes.push_back({object.T_world_object, object.instance.size});
  }
  for (const ClutterPiece& piece : scene.clutter) {
    taken.boxes.push_back(MakeSolid(piece.mesh, piece.T_world_mesh).around);
  }
  for (const Isometry3d& pose : CameraPoses(scene.path, scene.frames, scene.seed)) {
    taken.cameras.push_back(pose.translation());
  }
  return taken;
}

bool IsFree(const OrientedBox& box, const Taken& taken) {
  OrientedBox wide = box;
  wide.size += Vector3d(2 * kAround, 2 * kAround, 0);
  const bool is_clear = std::none_of(taken.boxes.begin(), taken.boxes.end(), [&](const OrientedBox& other) {
    return IntersectionVolume(wide, other) > 1e-9;
  });
  return is_clear && std::none_of(taken.cameras.begin(), taken.cameras.end(), [&](const Vector3d& camera) {
           return IsNear(box, camera, kCameraDistance);
         });
}

double TurnedBy(Random& random, double most_deg) { return random.Uniform(-most_deg, most_deg) * kDegree; }

ClutterPiece Drawn(const std::string& shape, const Vector3d& size, Random& random) {
  return {ClutterMesh(shape, size, DrawClutterColour(shape, random), random), Isometry3d::Identity(), shape,
          ""};
}

ClutterPiece ForFloor(Random& random) {
  const double kind = random.Uniform(0, 1);
  const auto uniform = [&](double low, double high) { return random.Uniform(low, high); };
  if (kind < 0.45) return Drawn("box", {uniform(0.25, 0.6), uniform(0.2, 0.45), uniform(0.15, 0.5)}, random);
  if (kind < 0.75) {
    const double diameter = uniform(0.22, 0.36);
    return Drawn("cylinder", {diameter, diameter, uniform(0.28, 0.6)}, random);
  }
  if (kind < 0.9) return Drawn("books", {0.2, 0.28, uniform(0.06, 0.3)}, random);
  return Drawn("paper", {0.21, 0.297, 0.002}, random);
}

ClutterPiece ForTable(Random& random) {
  const double kind = random.Uniform(0, 1);
  const auto uniform = [&](double low, double high) { return random.Uniform(low, high); };
  if (kind < 0.35)
    return Drawn("books", {uniform(0.13, 0.2), uniform(0.19, 0.27), uniform(0.02, 0.1)}, random);
  if (kind < 0.7) return Drawn("paper", {0.21, 0.297, uniform(0.001, 0.004)}, random);
  if (kind < 0.9) {
    const double diameter = uniform(0.07, 0.1);
    return Drawn("cylinder", {diameter, diameter, uniform(0.08, 0.14)}, random);
  }
  return Drawn("box", {uniform(0.1, 0.22), uniform(0.08, 0.16), uniform(0.05, 0.12)}, random);
}

// Along a wall, roughly parallel to it.
ClutterPiece AtWall(const Room& room, Random& random) {
  ClutterPiece piece = ForFloor(random);
  const Wall wall = MakeWalls(room)[static_cast<size_t>(random.Uniform(0, 4))];
  const Vector3d size = BoundingBox(piece.mesh).sizes();
  const double reach = 0.5 * size.head<2>().norm();
  const double along = random.Uniform(-0.5, 0.5) * (wall.width - 2 * reach);
  const double before = 0.5 * size.y() + random.Uniform(0.08, 0.35);
  const Eigen::AngleAxisd flat(-90 * kDegree, Vector3d::UnitX());  // from the wall's frame to one with z up
  const Eigen::AngleAxisd turned(TurnedBy(random, 12), Vector3d::UnitZ());
  piece.T_world_mesh = wall.T_world_wall * Translation3d(along, 0, before) * flat * turned;
  return piece;
}

ClutterPiece OnTable(const SceneObject& table, Random& random) {
  ClutterPiece piece = ForTable(random);
  const Vector3d size = BoundingBox(piece.mesh).sizes();
  const double reach = 0.5 * size.head<2>().norm() + 0.01;
  const Vector3d top = table.instance.size;
  const double x = random.Uniform(-0.5, 0.5) * std::max(0.0, top.x() - 2 * reach);
  const double y = random.Uniform(-0.5, 0.5) * std::max(0.0, top.z() - 2 * reach);
  piece.T_world_mesh =
      FindTop(table) * Translation3d(x, y, 0) * Eigen::AngleAxisd(TurnedBy(random, 180), Vector3d::UnitZ());
  return piece;
}

// Adds `count` pieces, each the first of some attempts that is free.
template <typename Draw>
void AddPieces(int count, const Draw& draw, Taken* taken, std::vector<ClutterPiece>* pieces) {
  for (int i = 0; i < count; ++i) {
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      const ClutterPiece piece = draw();
      const OrientedBox box = MakeSolid(piece.mesh, piece.T_world_mesh).around;
      if (!IsFree(box, *taken)) continue;
      taken->boxes.push_back(box);
      pieces->push_back(piece);
      break;
    }
  }
}

}  // namespace

std::vector<ClutterPiece> ScatteredClutter(const Scene& scene) {
  Taken taken = TakenBy(scene);
  Random random(scene.seed + 1234567);
  std::vector<ClutterPiece> pieces;
  AddPieces(
      scene.room.clutter, [&] { return AtWall(scene.room, random); }, &taken, &pieces);
  for (const SceneObject& object : scene.objects) {
    if (object.instance.category != "table") continue;
    AddPieces(
        scene.room.table_clutter, [&] { return OnTable(object, random); }, &taken, &pieces);
  }
  return pieces;
}

}  // namespace armature
