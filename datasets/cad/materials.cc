// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/cad/materials.h"

#include <algorithm>
#include <array>

namespace armature {
namespace {

constexpr double kThinLeg = 0.026;       // chairs' of metal, metres
constexpr double kThinTableLeg = 0.041;  // tables' of metal

// One of the colours, somewhat lighter or darker.
template <size_t kCount>
Colour DrawColour(Random& random, const std::array<std::array<double, 3>, kCount>& colours) {
  const auto& [red, green, blue] = colours[static_cast<size_t>(random.Uniform(0, kCount))];
  const double lightness = random.Uniform(0.9, 1.1);
  return (lightness * Colour(red, green, blue)).cwiseMin(1.0);
}

Material Make(Texture texture, const Colour& colour, double second, double scale, double gloss) {
  Material material;
  material.texture = texture;
  material.colour = colour;
  material.second = second * colour;
  material.scale = scale;
  material.gloss = gloss;
  return material;
}

}  // namespace

Material DrawWood(Random& random) {
  static constexpr std::array<std::array<double, 3>, 8> kWoods = {{{0.85, 0.70, 0.50},    // birch
                                                                   {0.80, 0.62, 0.42},    // beech
                                                                   {0.74, 0.57, 0.37},    // oak
                                                                   {0.66, 0.48, 0.30},    // old oak
                                                                   {0.58, 0.36, 0.22},    // cherry
                                                                   {0.45, 0.29, 0.19},    // walnut
                                                                   {0.33, 0.21, 0.15},    // dark walnut
                                                                   {0.22, 0.17, 0.14}}};  // wenge
  const Colour colour = DrawColour(random, kWoods);
  const double grain = random.Uniform(0.70, 0.88), distance = random.Uniform(0.006, 0.014);
  return Make(Texture::kWood, colour, grain, distance, random.Uniform(0.05, 0.3));
}

Material DrawPaint(Random& random) {
  static constexpr std::array<std::array<double, 3>, 7> kPaints = {{{0.90, 0.89, 0.86},
                                                                    {0.82, 0.80, 0.75},
                                                                    {0.16, 0.16, 0.17},
                                                                    {0.42, 0.44, 0.45},
                                                                    {0.45, 0.53, 0.56},
                                                                    {0.46, 0.52, 0.42},
                                                                    {0.50, 0.22, 0.18}}};
  const Colour colour = DrawColour(random, kPaints);
  return Make(Texture::kPlain, colour, 0.93, 0.05, random.Uniform(0.1, 0.3));
}

Material DrawFabric(Random& random) {
  static constexpr std::array<std::array<double, 3>, 8> kFabrics = {{{0.55, 0.52, 0.48},
                                                                     {0.36, 0.37, 0.39},
                                                                     {0.20, 0.21, 0.23},
                                                                     {0.72, 0.66, 0.55},
                                                                     {0.28, 0.36, 0.47},
                                                                     {0.40, 0.45, 0.36},
                                                                     {0.55, 0.30, 0.25},
                                                                     {0.48, 0.35, 0.26}}};
  const Colour colour = DrawColour(random, kFabrics);
  return Make(Texture::kFabric, colour, random.Uniform(0.75, 0.9), random.Uniform(0.003, 0.006), 0);
}

Material DrawMetal(Random& random) {
  static constexpr std::array<std::array<double, 3>, 4> kMetals = {
      {{0.72, 0.73, 0.74}, {0.55, 0.56, 0.57}, {0.13, 0.13, 0.14}, {0.86, 0.86, 0.85}}};
  const Colour colour = DrawColour(random, kMetals);
  return Make(Texture::kPlain, colour, 0.97, 0.05, random.Uniform(0.4, 0.7));
}

Material DrawPlastic(Random& random) {
  static constexpr std::array<std::array<double, 3>, 7> kPlastics = {{{0.90, 0.90, 0.88},
                                                                      {0.14, 0.14, 0.15},
                                                                      {0.45, 0.46, 0.47},
                                                                      {0.32, 0.43, 0.50},
                                                                      {0.52, 0.56, 0.48},
                                                                      {0.66, 0.34, 0.24},
                                                                      {0.76, 0.63, 0.32}}};
  const Colour colour = DrawColour(random, kPlastics);
  return Make(Texture::kPlain, colour, 0.96, 0.05, random.Uniform(0.2, 0.5));
}

ChairMaterials DrawChairMaterials(Random& random, const ChairParameters& chair) {
  const bool is_metal = chair.leg<kThinLeg, is_padded = chair.back_thickness> chair.leg;
  const bool is_painted = random.Uniform(0, 1) < 0.25;
  ChairMaterials materials;
  materials.frame = is_metal ? DrawMetal(random) : is_painted ? DrawPaint(random) : DrawWood(random);
  const Material fabric = DrawFabric(random);
  const Material board = !is_metal                    ? materials.frame
                         : random.Uniform(0, 1) < 0.6 ? DrawPlastic(random)
                                                      : DrawWood(random);
  materials.seat = chair.cushion > 0 ? fabric : board;
  materials.back = is_padded ? fabric : board;
  return materials;
}

TableMaterials DrawTableMaterials(Random& random, const TableParameters& table) {
  const bool is_painted = random.Uniform(0, 1) < 0.3, legs_match = random.Uniform(0, 1) < 0.7;
  TableMaterials materials;
  materials.top = is_painted ? DrawPaint(random) : DrawWood(random);
  const Material other = DrawPaint(random), metal = DrawMetal(random);
  materials.legs = table.leg < kThinTableLeg ? metal : legs_match ? materials.top : other;
  return materials;
}

LaptopMaterials DrawLaptopMaterials(Random& random) {
  static constexpr std::array<std::array<double, 3>, 5> kBodies = {
      {{0.75, 0.76, 0.78}, {0.50, 0.51, 0.54}, {0.28, 0.29, 0.31}, {0.13, 0.13, 0.14}, {0.85, 0.85, 0.84}}};
  static constexpr std::array<std::array<double, 3>, 4> kScreens = {
      {{0.62, 0.74, 0.88}, {0.80, 0.84, 0.88}, {0.30, 0.42, 0.60}, {0.24, 0.27, 0.32}}};
  LaptopMaterials materials;
  materials.body = Make(Texture::kPlain, DrawColour(random, kBodies), 0.97, 0.05, 0.3);
  const bool is_dark = random.Uniform(0, 1) < 0.75;
  materials.bezel = is_dark ? Make(Texture::kPlain, {0.07, 0.07, 0.08}, 0.95, 0.05, 0.3) : materials.body;
  materials.screen = Make(Texture::kScreen, DrawColour(random, kScreens), 0.4, 0.02, 0.2);
  materials.keyboard = Make(Texture::kKeyboard, {0.10, 0.10, 0.11}, 2.2, 0.018, 0.1);
  materials.touchpad = materials.body;
  materials.touchpad.colour *= 0.88;
  return materials;
}

}  // namespace armature
