// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/scene/walls.h"

#include <algorithm>
#include <vector>

#include "datasets/cad/solids.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

const Colour kLacquer(0.9, 0.89, 0.86);

unsigned PictureSeed(Random& random) { return static_cast<unsigned>(random.Uniform(0, 1e6)); }

Material WallPaint(const Colour& colour, double gloss) {
  return {Texture::kPlain, colour, 0.9 * colour, 0.1, gloss, 0};
}

// A wall with the stretches along it that are taken.
class WallSpace {
 public:
  explicit WallSpace(const Wall& wall) : wall_(wall) {}

  const Wall& wall() const { return wall_; }

  // Takes `width` around x with a margin; false where there is no space for it.
  bool Take(double x, double width) {
    constexpr double kMargin = 0.15;
    const double low = x - 0.5 * width - kMargin, high = x + 0.5 * width + kMargin;
    if (low < -0.5 * wall_.width || high > 0.5 * wall_.width) return false;
    const bool is_taken = std::any_of(taken_.begin(), taken_.end(), [&](const Vector2d& stretch) {
      return low < stretch.y() && high > stretch.x();
    });
    if (!is_taken) taken_.emplace_back(low, high);
    return !is_taken;
  }

 private:
  Wall wall_;
  std::vector<Vector2d> taken_;  // from, to
};

// A block on the wall between two corners of the wall's plane, from `from` to `to` metres in front of it.
void AddBlock(const Wall& wall, const Vector2d& low, const Vector2d& high, double from, double to,
              const Material& material, Mesh* mesh) {
  const Vector2d centre = 0.5 * (low + high), size = high - low;
  mesh->parts.push_back(Block(wall.T_world_wall * Translation3d(centre.x(), centre.y(), 0.5 * (from + to)),
                              {size.x(), size.y(), to - from}, material));
}

void AddSheet(const Wall& wall, const Vector2d& low, const Vector2d& high, double before,
              const Material& material, Mesh* mesh) {
  const Vector2d centre = 0.5 * (low + high);
  mesh->parts.push_back(
      Sheet(wall.T_world_wall * Translation3d(centre.x(), centre.y(), before), high - low, material));
}

// Four strips around the rectangle's inside.
void AddFrame(const Wall& wall, const Vector2d& low, const Vector2d& high, double strip, double depth,
              const Material& material, Mesh* mesh) {
  const auto add = [&](double x0, double y0, double x1, double y1) {
    AddBlock(wall, {x0, y0}, {x1, y1}, 0, depth, material, mesh);
  };
  add(low.x(), low.y(), low.x() + strip, high.y());
  add(high.x() - strip, low.y(), high.x(), high.y());
  add(low.x() + strip, low.y(), high.x() - strip, low.y() + strip);
  add(low.x() + strip, high.y() - strip, high.x() - strip, high.y());
}

void AddDoor(const Wall& wall, double x, const Colour& colour, Mesh* mesh) {
  constexpr double kHalf = 0.48, kTop = 2.06, kCasing = 0.07;  // metres
  const double half = kHalf - kCasing;
  const Material casing = WallPaint(kLacquer, 0.3);
  AddBlock(wall, {x - kHalf, 0}, {x - half, kTop}, 0, 0.035, casing, mesh);
  AddBlock(wall, {x + half, 0}, {x + kHalf, kTop}, 0, 0.035, casing, mesh);
  AddBlock(wall, {x - half, kTop - kCasing}, {x + half, kTop}, 0, 0.035, casing, mesh);
  const Material leaf = WallPaint(colour, 0.3);
  AddBlock(wall, {x - half, 0.01}, {x + half, kTop - kCasing}, 0, 0.02, leaf, mesh);
  AddBlock(wall, {x - half + 0.12, 0.2}, {x + half - 0.12, 0.85}, 0.02, 0.026, leaf, mesh);
  AddBlock(wall, {x - half + 0.12, 1.05}, {x + half - 0.12, 1.85}, 0.02, 0.026, leaf, mesh);
  AddBlock(wall, {x + half - 0.09, 0.98}, {x + half - 0.05, 1.02}, 0.02, 0.07,
           WallPaint({0.6, 0.6, 0.62}, 0.8), mesh);
}

// Two casements before a bright sky that is no light, and a sill.
void AddWindow(const Wall& wall, double x, double width, Mesh* mesh) {
  constexpr double kLow = 0.9, kHigh = 2.2, kStrip = 0.06;  // metres
  const double half = 0.5 * width;
  const Material white = WallPaint(kLacquer, 0.3);
  AddSheet(wall, {x - half, kLow}, {x + half, kHigh}, 0.004, WallPaint({0.78, 0.84, 0.9}, 0.9), mesh);
  AddFrame(wall, {x - half, kLow}, {x, kHigh}, kStrip, 0.04, white, mesh);
  AddFrame(wall, {x, kLow}, {x + half, kHigh}, kStrip, 0.04, white, mesh);
  AddBlock(wall, {x - half - 0.05, kLow - 0.04}, {x + half + 0.05, kLow}, 0, 0.15, white, mesh);
}

// Frame, passe-partout and the painting.
void AddPicture(const Wall& wall, const Vector2d& centre, const Vector2d& size, Random& random, Mesh* mesh) {
  constexpr double kFrame = 0.025;
  const double mat = random.Uniform(0.04, 0.1) + kFrame;
  const double shade = random.Uniform(0.1, 0.6);
  const Colour wood(shade, 0.85 * shade, 0.7 * shade);
  const Vector2d low = centre - 0.5 * size, high = centre + 0.5 * size;
  AddFrame(wall, low, high, kFrame, 0.022, WallPaint(wood, 0.3), mesh);
  AddSheet(wall, low, high, 0.008, WallPaint({0.9, 0.89, 0.85}, 0), mesh);
  const Colour first(random.Uniform(0.25, 0.7), random.Uniform(0.3, 0.6), random.Uniform(0.25, 0.65));
  const Colour second(random.Uniform(0.2, 0.8), random.Uniform(0.2, 0.7), random.Uniform(0.15, 0.6));
  const Material painting{Texture::kPicture, first, second, 0.15, 0.1, PictureSeed(random)};
  AddSheet(wall, low + Vector2d(mat, mat), high - Vector2d(mat, mat), 0.009, painting, mesh);
}

bool TryPicture(const Room& room, Random& random, std::array<WallSpace, 4>* walls, Mesh* mesh) {
  WallSpace& space = (*walls)[static_cast<size_t>(random.Uniform(0, 4))];
  const Vector2d size(random.Uniform(0.35, 0.9), random.Uniform(0.4, 0.7));
  const double x = random.Uniform(-0.5, 0.5) * space.wall().width;
  const double y = random.Uniform(1.45, 1.65);
  if (y + 0.5 * size.y() > room.size.z() - 0.1 || !space.Take(x, size.x())) return false;
  AddPicture(space.wall(), {x, y}, size, random, mesh);
  return true;
}

}  // namespace

std::array<Wall, 4> MakeWalls(const Room& room) {
  std::array<Wall, 4> walls;
  for (size_t i = 0; i < 4; ++i) {
    const Eigen::AngleAxisd turned(90 * kDegree * static_cast<double>(i), Vector3d::UnitZ());
    const Eigen::AngleAxisd upright(90 * kDegree, Vector3d::UnitX());
    const bool is_along_x = i % 2 == 0;
    walls[i].width = is_along_x ? room.size.x() : room.size.y();
    walls[i].height = room.size.z();
    const double distance = 0.5 * (is_along_x ? room.size.y() : room.size.x());
    walls[i].T_world_wall = turned * Translation3d(0, distance, 0) * upright;
  }
  return walls;
}

Part Sheet(const Isometry3d& T_mesh_sheet, const Vector2d& size, const Material& material) {
  const double x = 0.5 * size.x(), y = 0.5 * size.y();
  Quad quad{{Vector3d(-x, -y, 0), Vector3d(x, -y, 0), Vector3d(x, y, 0), Vector3d(-x, y, 0)}};
  for (Vector3d& corner : quad.corners) corner = T_mesh_sheet * corner;
  return {material, T_mesh_sheet, {quad}};
}

Mesh WallDecoration(const Room& room, Random& random) {
  const std::array<Wall, 4> walls = MakeWalls(room);
  std::array<WallSpace, 4> spaces{WallSpace(walls[0]), WallSpace(walls[1]), WallSpace(walls[2]),
                                  WallSpace(walls[3])};
  Mesh mesh;
  const size_t first = static_cast<size_t>(random.Uniform(0, 4));
  WallSpace &of_door = spaces[first], &of_window = spaces[(first + 1) % 4];
  const double door = random.Uniform(-0.3, 0.3) * of_door.wall().width;
  const double shade = random.Uniform(0.55, 0.85);
  if (room.size.z() > 2.2 && of_door.Take(door, 0.96)) {
    AddDoor(of_door.wall(), door, {shade, 0.92 * shade, 0.8 * shade}, &mesh);
  }
  const double window = random.Uniform(-0.2, 0.2) * of_window.wall().width;
  const double width = random.Uniform(1.2, 1.8);
  if (room.size.z() > 2.3 && of_window.Take(window, width)) {
    AddWindow(of_window.wall(), window, width, &mesh);
  }
  int left = room.pictures;
  for (int attempt = 0; left > 0 && attempt < 40 * room.pictures; ++attempt) {
    if (TryPicture(room, random, &spaces, &mesh)) --left;
  }
  return mesh;
}

}  // namespace armature
