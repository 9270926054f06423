// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/rooms/room_looks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace armature {
namespace {

using Eigen::Vector3d;

Colour InRange(const Colour& colour) { return colour.cwiseMin(1.0).cwiseMax(0.0).unaryExpr(&RoundDrawn); }

Colour Shade(const std::array<Colour, 4>& colours, Random& random) {
  const Colour& colour = colours[static_cast<size_t>(random.Uniform(0, 4))];
  return random.Uniform(0.88, 1.1) * colour;
}

Material Looks(Texture texture, const Colour& colour, double second, double scale, double gloss) {
  return {texture, InRange(colour), InRange(second * colour), RoundDrawn(scale), RoundDrawn(gloss), 0};
}

Material DrawFloor(const std::string& texture, Random& random) {
  using Four = std::array<Colour, 4>;
  if (texture == "carpet")
    return Looks(
        Texture::kCarpet,
        Shade(Four{Colour(0.42, 0.4, 0.38), {0.3, 0.33, 0.4}, {0.52, 0.46, 0.38}, {0.36, 0.28, 0.26}},
              random),
        0.75, random.Uniform(0.006, 0.02), 0);
  if (texture == "tiles")
    return Looks(
        Texture::kTiles,
        Shade(Four{Colour(0.72, 0.7, 0.66), {0.55, 0.53, 0.5}, {0.65, 0.52, 0.42}, {0.4, 0.41, 0.42}},
              random),
        random.Uniform(0.55, 0.85), random.Uniform(0.2, 0.6), random.Uniform(0.1, 0.5));
  const Four woods{Colour(0.62, 0.47, 0.32), {0.5, 0.35, 0.22}, {0.72, 0.6, 0.44}, {0.36, 0.26, 0.19}};
  if (texture == "boards" || texture == "wood")
    return Looks(texture == "wood" ? Texture::kWood : Texture::kBoards, Shade(woods, random),
                 random.Uniform(0.5, 0.75), texture == "wood" ? 0.02 : random.Uniform(0.08, 0.2),
                 random.Uniform(0.05, 0.35));
  return Looks(
      texture == "fabric" ? Texture::kFabric : Texture::kPlain,
      Shade(Four{Colour(0.5, 0.5, 0.49), {0.6, 0.58, 0.53}, {0.42, 0.44, 0.47}, {0.55, 0.5, 0.44}}, random),
      0.93, texture == "fabric" ? 0.006 : 0.3, texture == "fabric" ? 0 : random.Uniform(0, 0.3));
}

Material DrawWalls(const std::string& texture, Random& random) {
  using Four = std::array<Colour, 4>;
  const Colour paint = Shade(
      Four{Colour(0.86, 0.84, 0.79), {0.8, 0.82, 0.84}, {0.78, 0.72, 0.62}, {0.62, 0.68, 0.62}}, random);
  if (texture == "tiles") return Looks(Texture::kTiles, paint, 0.8, random.Uniform(0.15, 0.3), 0.3);
  if (texture == "boards" || texture == "wood")
    return Looks(
        texture == "wood" ? Texture::kWood : Texture::kBoards,
        Shade(Four{Colour(0.7, 0.55, 0.38), {0.8, 0.76, 0.68}, {0.55, 0.4, 0.27}, {0.86, 0.85, 0.82}},
              random),
        0.75, texture == "wood" ? 0.02 : random.Uniform(0.1, 0.25), 0.05);
  if (texture == "fabric") return Looks(Texture::kFabric, paint, 0.9, 0.006, 0);
  return Looks(texture == "carpet" ? Texture::kCarpet : Texture::kPlain, paint, 0.93, 0.5, 0);
}

// From daylight to a warm bulb.
Colour LampColour(double warmth) { return InRange(Colour(1, 0.97 - 0.13 * warmth, 0.95 - 0.38 * warmth)); }

// In a row along the longer side, or wherever they hang.
std::vector<Lamp> DrawLamps(const Vector3d& room, int count, double warmth, Random& random) {
  const bool is_panel = random.Uniform(0, 1) < 0.4, along_x = room.x() >= room.y();
  const double drop = random.Uniform(0.06, 0.3), row = random.Uniform(-0.15, 0.15);
  Eigen::Vector2d size = is_panel ? Eigen::Vector2d(0.6, 0.6) : Eigen::Vector2d(1.2, 0.3);
  if (!along_x) std::swap(size.x(), size.y());
  std::vector<Lamp> lamps;
  for (int i = 0; i < count; ++i) {
    const double share = (i + 0.5) / count - 0.5 + random.Uniform(-0.05, 0.05);
    const Eigen::Vector2d at = along_x ? Eigen::Vector2d(share, row) : Eigen::Vector2d(row, share);
    Lamp lamp;
    const Eigen::Vector2d most = 0.5 * (room.head<2>() - size) - Eigen::Vector2d::Constant(0.05);
    const Eigen::Vector2d inside = at.cwiseProduct(room.head<2>()).cwiseMax(-most).cwiseMin(most);
    lamp.centre = Vector3d(inside.x(), inside.y(), room.z() - drop).unaryExpr(&RoundDrawn);
    lamp.size = size;
    lamp.colour = LampColour(warmth);
    lamp.power = RoundDrawn(random.Uniform(0.5, 1.5));
    lamps.push_back(lamp);
  }
  return lamps;
}

}  // namespace

void DrawLooks(const RoomRecipe& recipe, std::uint64_t seed, Scene* scene) {
  Random random(seed);
  Room& room = scene->room;
  room.size.x() = DrawNumber(recipe.width, random);
  room.size.y() = DrawNumber(recipe.depth, random);
  room.size.z() = DrawNumber(recipe.height, random);
  room.floor = DrawFloor(DrawWord(recipe.floor, random), random);
  room.walls = DrawWalls(DrawWord(recipe.walls, random), random);
  room.pictures = DrawInteger(recipe.pictures, random);
  room.clutter = DrawInteger(recipe.clutter, random);
  room.table_clutter = DrawInteger(recipe.table_clutter, random);
  const int lamps = DrawInteger(recipe.lamps, random);
  scene->lamps = DrawLamps(room.size, lamps, DrawNumber(recipe.warmth, random), random);
}

}  // namespace armature
