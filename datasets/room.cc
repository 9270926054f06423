// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/room.h"

#include <algorithm>

#include "datasets/random.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Cuboid Block(const Vector3d& low, const Vector3d& high, const Colour& colour) {
  Cuboid cuboid;
  cuboid.T_parent_cuboid.translation() = 0.5 * (low + high);
  cuboid.size = high - low;
  cuboid.colour = colour;
  return cuboid;
}

// Boards of 0.14 m width along y on a dark ground, which shows between them.
void AddFloor(const RoomShape& shape, Random& random, std::vector<Cuboid>* blocks) {
  constexpr double kBoard = 0.14, kGap = 0.004;
  blocks->push_back(Block({shape.low.x(), shape.low.y(), -0.1}, {shape.high.x(), shape.high.y(), -0.003},
                          {0.2, 0.15, 0.1}));
  for (double x = shape.low.x(); x < shape.high.x(); x += kBoard) {
    double y = shape.low.y() - random.Uniform(0, 1.5);
    while (y < shape.high.y()) {
      const double end = y + random.Uniform(1.2, 2.0);
      const double shade = random.Uniform(0.92, 1.08);
      blocks->push_back(Block({x, std::max(y, shape.low.y()), -0.05},
                              {x + kBoard - kGap, std::min(end - kGap, shape.high.y()), 0},
                              shade * Colour(0.66, 0.5, 0.34)));
      y = end;
    }
  }
}

void AddWalls(const RoomShape& s, std::vector<Cuboid>* blocks) {
  const Colour wall(0.83, 0.82, 0.76), side_wall(0.74, 0.78, 0.8), board(0.95, 0.95, 0.93);
  constexpr double kThick = 0.1, kSkirting = 0.08, kDeep = 0.015;
  const double left = s.low.x(), right = s.high.x(), front = s.low.y(), rear = s.high.y();
  blocks->push_back(Block({left, rear, 0}, {right, rear + kThick, s.height}, wall));
  blocks->push_back(Block({left, front - kThick, 0}, {right, front, s.height}, wall));
  blocks->push_back(Block({left - kThick, front, 0}, {left, rear, s.height}, side_wall));
  blocks->push_back(Block({right, front, 0}, {right + kThick, rear, s.height}, side_wall));
  blocks->push_back(Block({left, rear - kDeep, 0}, {right, rear, kSkirting}, board));
  blocks->push_back(Block({left, front, 0}, {left + kDeep, rear, kSkirting}, board));
  blocks->push_back(Block({right - kDeep, front, 0}, {right, rear, kSkirting}, board));
}

// A frame with a passe-partout and a picture, on the rear wall.
void AddPicture(const RoomShape& s, double x, double z, const Vector2d& size, const Colour& colour,
                std::vector<Cuboid>* blocks) {
  const double wall = s.high.y();
  const Vector2d half = 0.5 * size;
  const auto layer = [&](double inset, double depth, const Colour& c) {
    blocks->push_back(Block({x - half.x() + inset, wall - depth, z - half.y() + inset},
                            {x + half.x() - inset, wall, z + half.y() - inset}, c));
  };
  layer(0, 0.020, {0.2, 0.17, 0.15});
  layer(0.025, 0.021, {0.93, 0.92, 0.88});
  layer(0.085, 0.022, colour);
}

void AddDecoration(const RoomShape& s, std::vector<Cuboid>* blocks) {
  AddPicture(s, -1.15, 1.55, {0.62, 0.46}, {0.35, 0.5, 0.55}, blocks);
  AddPicture(s, 0.55, 1.6, {0.4, 0.56}, {0.62, 0.4, 0.3}, blocks);
  AddPicture(s, 1.1, 1.6, {0.4, 0.56}, {0.45, 0.5, 0.3}, blocks);
  blocks->push_back(Block({-1.0, -0.75, 0}, {1.15, 1.35, 0.006}, {0.48, 0.3, 0.28}));  // rug with a border
  blocks->push_back(Block({-0.9, -0.65, 0}, {1.05, 1.25, 0.007}, {0.62, 0.56, 0.48}));
  const double right = s.high.x();
  blocks->push_back(
      Block({right - 0.03, 0.4, 0}, {right, 1.4, 2.05}, {0.94, 0.93, 0.9}));  // door in its frame
  blocks->push_back(Block({right - 0.034, 0.48, 0}, {right, 1.32, 1.97}, {0.7, 0.62, 0.5}));
}

constexpr double kCell = 0.025;  // metres, of the floor's light
constexpr int kLampPoints = 3;   // along each side of the lamp
constexpr double kLampSize = 0.9;

// A piece of furniture, world frame: a point that the box around it does not hide is not hidden by its parts.
struct Obstacle {
  Cuboid around;
  std::vector<Cuboid> parts;
};

Obstacle ObstacleOf(const PlacedFurniture& piece) {
  Obstacle obstacle;
  obstacle.around.T_parent_cuboid = piece.T_world_object;
  obstacle.around.size = piece.furniture.size;
  for (Cuboid part : piece.furniture.parts) {
    part.T_parent_cuboid = piece.T_world_object * part.T_parent_cuboid;
    obstacle.parts.push_back(part);
  }
  return obstacle;
}

bool Hides(const Obstacle& obstacle, const Vector3d& point, const Vector3d& lamp) {
  const auto blocks = [&](const Cuboid& cuboid) { return Blocks(cuboid, point, lamp); };
  return blocks(obstacle.around) && std::any_of(obstacle.parts.begin(), obstacle.parts.end(), blocks);
}

double LampShare(const Vector3d& point, const Vector3d& lamp, const std::vector<Obstacle>& obstacles) {
  int seen = 0;
  for (int i = 0; i < kLampPoints; ++i) {
    for (int j = 0; j < kLampPoints; ++j) {
      const Vector3d offset((i + 0.5) / kLampPoints - 0.5, (j + 0.5) / kLampPoints - 0.5, 0);
      const Vector3d at = lamp + kLampSize * offset;
      const bool hidden = std::any_of(obstacles.begin(), obstacles.end(),
                                      [&](const Obstacle& obstacle) { return Hides(obstacle, point, at); });
      if (!hidden) ++seen;
    }
  }
  return static_cast<double>(seen) / (kLampPoints * kLampPoints);
}

}  // namespace

PlacedFurniture Placed(const std::string& id, const Furniture& furniture, double x, double y, double yaw_deg,
                       double height) {
  PlacedFurniture placed{id, furniture};
  placed.T_world_object.translation() = Vector3d(x, y, height + 0.5 * furniture.size.y());
  placed.T_world_object.linear() = (Eigen::AngleAxisd(yaw_deg * kDegree, Vector3d::UnitZ()) *
                                    Eigen::AngleAxisd(90 * kDegree, Vector3d::UnitX()))
                                       .toRotationMatrix();
  return placed;
}

std::vector<Polygon> RoomPolygons(const RoomShape& shape, std::uint64_t seed) {
  Random random(seed);
  std::vector<Cuboid> blocks;
  AddFloor(shape, random, &blocks);
  AddWalls(shape, &blocks);
  AddDecoration(shape, &blocks);
  std::vector<Polygon> polygons;
  for (const Cuboid& block : blocks) {
    for (const Polygon& side : Sides(block, Eigen::Isometry3d::Identity(), 0)) polygons.push_back(side);
  }
  return polygons;
}

std::vector<Polygon> FurniturePolygons(const std::vector<PlacedFurniture>& furniture) {
  std::vector<Polygon> polygons;
  for (size_t i = 0; i < furniture.size(); ++i) {
    for (const Cuboid& part : furniture[i].furniture.parts) {
      for (const Polygon& side : Sides(part, furniture[i].T_world_object, static_cast<int>(i) + 1)) {
        polygons.push_back(side);
      }
    }
  }
  return polygons;
}

RoomLight::RoomLight(const RoomShape& shape, const std::vector<PlacedFurniture>& furniture)
    : lamp_(0.3, -0.6, shape.height - 0.1), low_(shape.low) {
  std::vector<Obstacle> obstacles;
  obstacles.reserve(furniture.size());
  for (const PlacedFurniture& piece : furniture) obstacles.push_back(ObstacleOf(piece));
  const Vector2d size = (shape.high - shape.low) / kCell;
  visibility_.create(static_cast<int>(size.y()) + 2, static_cast<int>(size.x()) + 2);
  for (int row = 0; row < visibility_.rows; ++row) {
    for (int column = 0; column < visibility_.cols; ++column) {
      const Vector3d point(low_.x() + column * kCell, low_.y() + row * kCell, 0.001);
      visibility_(row, column) = LampShare(point, lamp_, obstacles);
    }
  }
}

double RoomLight::FloorVisibility(const Vector3d& point) const {
  const double x = std::clamp((point.x() - low_.x()) / kCell, 0.0, visibility_.cols - 1.001);
  const double y = std::clamp((point.y() - low_.y()) / kCell, 0.0, visibility_.rows - 1.001);
  const int column = static_cast<int>(x), row = static_cast<int>(y);
  const double u = x - column, v = y - row;
  return (1 - v) * ((1 - u) * visibility_(row, column) + u * visibility_(row, column + 1)) +
         v * ((1 - u) * visibility_(row + 1, column) + u * visibility_(row + 1, column + 1));
}

double RoomLight::operator()(const Polygon& polygon, const Vector3d& point) const {
  const Vector3d to_lamp = lamp_ - point;
  const double facing = std::max(0.0, polygon.normal.dot(to_lamp.normalized()));
  const double fading = 1 / (1 + 0.06 * to_lamp.squaredNorm());
  const bool is_floor = polygon.object == 0 && polygon.normal.z() > 0.99 && point.z() < 0.01;
  const double seen = is_floor ? FloorVisibility(point) : 1.0;
  const double ambient = 0.45 + 0.1 * polygon.normal.z() + 0.05 * polygon.normal.x();
  return ambient + 0.9 * facing * fading * seen;
}

}  // namespace armature
