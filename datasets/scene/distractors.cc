// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/scene/distractors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "datasets/cad/materials.h"
#include "datasets/cad/solids.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Vector3d;

unsigned PartSeed(Random& random) { return static_cast<unsigned>(random.Uniform(0, 1e6)); }

Material Of(Texture texture, const Colour& colour, double scale, double gloss, Random& random) {
  return {texture, colour.cwiseMin(1.0), 0.82 * colour, scale, gloss, PartSeed(random)};
}

Material Wood(const Colour& colour, Random& random) { return Of(Texture::kWood, colour, 0.01, 0.15, random); }

Material DarkMetal(Random& random) { return Of(Texture::kPlain, {0.16, 0.16, 0.17}, 0.05, 0.4, random); }

void AddBlock(Mesh* mesh, const Vector3d& low, const Vector3d& high, const Material& material) {
  mesh->parts.push_back(Block(low, high, material));
}

// Base, back, arms, seat and back cushions on low feet.
Mesh Sofa(const Vector3d& size, const Colour& colour, Random& random) {
  const double x = 0.5 * size.x(), y = 0.5 * size.y(), feet = std::min(0.08, 0.1 * size.z());
  const double arm = std::min(random.Uniform(0.12, 0.2), 0.2 * size.x());
  const double back = std::min(0.22, 0.3 * size.y()), base = 0.36 * size.z(), seat = 0.53 * size.z();
  const Material fabric = Of(Texture::kFabric, colour, 0.004, 0, random);
  Mesh mesh;
  AddBlock(&mesh, {-x, -y, feet}, {x, y, base}, fabric);
  AddBlock(&mesh, {-x, y - back, base}, {x, y, size.z()}, fabric);
  const double arms_top = random.Uniform(0.66, 0.76) * size.z();
  AddBlock(&mesh, {-x, -y, base}, {-x + arm, y - back, arms_top}, fabric);
  AddBlock(&mesh, {x - arm, -y, base}, {x, y - back, arms_top}, fabric);
  const int seats = std::max(1, static_cast<int>(std::lround((size.x() - 2 * arm) / 0.65)));
  const double wide = (size.x() - 2 * arm) / seats;
  for (int i = 0; i < seats; ++i) {
    const double left = -x + arm + i * wide + 0.006, right = left + wide - 0.012;
    AddBlock(&mesh, {left, -y + 0.01, base}, {right, y - back, seat},
             Of(Texture::kFabric, 1.04 * colour, 0.004, 0, random));
    AddBlock(&mesh, {left, y - back - 0.14, seat}, {right, y - back, 0.93 * size.z()},
             Of(Texture::kFabric, 1.04 * colour, 0.004, 0, random));
  }
  for (const double side : {-1.0, 1.0}) {
    for (const double end : {-1.0, 1.0}) {
      const Vector3d at(side * (x - 0.06), end * (y - 0.06), 0);
      AddBlock(&mesh, at - Vector3d(0.025, 0.025, 0), at + Vector3d(0.025, 0.025, feet), DarkMetal(random));
    }
  }
  return mesh;
}

// A round seat on four straight legs with a ring, or on a column.
Mesh Stool(const Vector3d& size, const Colour& colour, Random& random) {
  const double radius = 0.5 * std::min(size.x(), size.y()), seat = std::min(0.05, 0.15 * size.z());
  const Material wood = Wood(colour, random);
  Mesh mesh;
  mesh.parts.push_back(Cylinder({0, 0, size.z() - seat}, {0, 0, size.z()}, 0.96 * radius, radius, 28, wood));
  if (random.Uniform(0, 1) < 0.35) {
    mesh.parts.push_back(Cylinder({0, 0, 0.03}, {0, 0, size.z() - seat}, 0.03, 0.025, 16, DarkMetal(random)));
    mesh.parts.push_back(
        Cylinder({0, 0, 0}, {0, 0, 0.03}, 0.85 * radius, 0.8 * radius, 24, DarkMetal(random)));
    return mesh;
  }
  const double foot = 0.66 * radius, top = 0.52 * radius, half = 0.017;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-1.0, 1.0}) {
      mesh.parts.push_back(Beam({a * foot, b * foot, 0}, {a * top, b * top, size.z() - seat}, 2,
                                {2 * half, 2 * half}, {2 * half, 2 * half}, wood));
    }
    const double height = 0.3 * size.z(), at = foot - 0.3 * (foot - top);
    AddBlock(&mesh, {-at, a * at - 0.01, height}, {at, a * at + 0.01, height + 0.025}, wood);
    AddBlock(&mesh, {a * at - 0.01, -at, height + 0.04}, {a * at + 0.01, at, height + 0.065}, wood);
  }
  return mesh;
}

// A body on a plinth, with rows of doors or drawers that have handles.
Mesh Cabinet(const Vector3d& size, const Colour& colour, Random& random) {
  const double x = 0.5 * size.x(), y = 0.5 * size.y(), plinth = 0.06, front = 0.018, gap = 0.004;
  const Material wood = Wood(colour, random);
  Mesh mesh;
  AddBlock(&mesh, {-x + 0.03, -y + 0.05, 0}, {x - 0.03, y, plinth}, Wood(0.6 * colour, random));
  AddBlock(&mesh, {-x, -y + front, plinth}, {x, y, size.z()}, wood);
  const int columns = std::max(1, static_cast<int>(std::lround(size.x() / 0.45)));
  const bool has_drawers = random.Uniform(0, 1) < 0.5;
  const int rows = has_drawers ? std::max(2, static_cast<int>(std::lround((size.z() - plinth) / 0.24)))
                               : std::max(1, static_cast<int>(std::lround((size.z() - plinth) / 0.9)));
  const double wide = size.x() / columns, high = (size.z() - plinth) / rows;
  const Material metal = DarkMetal(random);
  for (int i = 0; i < columns; ++i) {
    for (int k = 0; k < rows; ++k) {
      const Vector3d low(-x + i * wide + gap, -y + 0.008, plinth + k * high + gap);
      const Vector3d high_corner(-x + (i + 1) * wide - gap, -y + front, plinth + (k + 1) * high - gap);
      AddBlock(&mesh, low, high_corner, Wood(1.05 * colour, random));
      const Vector3d middle = 0.5 * (low + high_corner);
      const Vector3d handle = has_drawers ? Vector3d(0.06, 0, 0.006) : Vector3d(0.006, 0, 0.06);
      const double aside = has_drawers ? 0 : (i % 2 == 0 ? 0.5 * wide - 0.05 : 0.05 - 0.5 * wide);
      const Vector3d centre(middle.x() + aside, 0, middle.z());
      AddBlock(&mesh, Vector3d(centre.x(), -y, centre.z()) - handle,
               Vector3d(centre.x(), -y + 0.008, centre.z()) + handle, metal);
    }
  }
  return mesh;
}

void AddShelfBooks(Mesh* mesh, const Vector3d& low, double wide, double high, double deep, Random& random) {
  double at = 0.01 + random.Uniform(0, 0.3) * wide;
  const double end = std::min(wide - 0.01, at + random.Uniform(0.2, 0.9) * wide);
  while (true) {
    const double thick = random.Uniform(0.02, 0.05), tall = random.Uniform(0.55, 0.88) * high;
    if (at + thick > end) return;
    const Colour colour(random.Uniform(0.2, 0.8), random.Uniform(0.2, 0.65), random.Uniform(0.2, 0.6));
    AddBlock(mesh, low + Vector3d(at, random.Uniform(0.01, 0.04), 0),
             low + Vector3d(at + thick - 0.002, 0.75 * deep, tall),
             Of(Texture::kPlain, colour, 0.1, 0.1, random));
    at += thick;
  }
}

// Sides, boards, a back, and books on some of the boards.
Mesh Shelf(const Vector3d& size, const Colour& colour, Random& random) {
  const double x = 0.5 * size.x(), y = 0.5 * size.y(), board = 0.022;
  const Material wood = Wood(colour, random);
  Mesh mesh;
  for (const double side : {-1.0, 1.0}) {
    const double inner = side * (x - board);
    AddBlock(&mesh, {std::min(side * x, inner), -y, 0}, {std::max(side * x, inner), y, size.z()}, wood);
  }
  AddBlock(&mesh, {-x + board, y - 0.008, 0}, {x - board, y, size.z()}, Wood(0.85 * colour, random));
  const int boards = std::max(2, static_cast<int>(std::lround(size.z() / 0.36)));
  const double step = (size.z() - board) / boards;
  for (int i = 0; i <= boards; ++i) {
    const double low = i * step;
    AddBlock(&mesh, {-x + board, -y, low}, {x - board, y - 0.008, low + board}, Wood(colour, random));
    if (i == boards || random.Uniform(0, 1) < 0.3) continue;
    AddShelfBooks(&mesh, {-x + board, -y, low + board}, size.x() - 2 * board, step - board, size.y() - 0.03,
                  random);
  }
  return mesh;
}

// A flat leaf from its stalk: two quads, as it is seen from both sides.
Part Leaf(const Vector3d& root, const Vector3d& along, double width, const Material& material) {
  Vector3d side = along.cross(Vector3d::UnitZ());
  side = (side.norm() > 1e-6 ? side : Vector3d(Vector3d::UnitX())).normalized() * 0.5 * width;
  const Vector3d middle = root + 0.55 * along, tip = root + along;
  Part leaf;
  leaf.material = material;
  leaf.T_mesh_part.translation() = middle;
  leaf.quads.push_back({{root, middle + side, tip, middle - side}});
  return leaf;
}

// A pot, a stem, and leaves around it that end within the size.
Mesh Plant(const Vector3d& size, const Colour& colour, Random& random) {
  const double radius = 0.5 * std::min(size.x(), size.y()), pot = std::min(0.35, 0.3 * size.z());
  const double pot_radius = std::min(0.17, 0.75 * radius);
  Mesh mesh;
  mesh.parts.push_back(Cylinder(Vector3d::Zero(), {0, 0, pot}, 0.75 * pot_radius, pot_radius, 24,
                                Of(Texture::kPlain, colour, 0.1, 0.1, random)));
  mesh.parts.push_back(Cylinder({0, 0, pot}, {0, 0, pot + 0.002}, 0.9 * pot_radius, 0.9 * pot_radius, 24,
                                Of(Texture::kCarpet, {0.2, 0.14, 0.1}, 0.01, 0, random)));
  mesh.parts.push_back(Cylinder({0, 0, pot}, {0, 0, size.z()}, 0.015, 0.004, 8,
                                Of(Texture::kPlain, {0.3, 0.26, 0.15}, 0.05, 0, random)));
  const int leaves = 34;
  for (int i = 0; i < leaves; ++i) {
    const double share = (i + 0.5) / leaves, angle = 2.4 * i;  // the golden angle, about
    const Vector3d root(0, 0, pot + 0.05 + share * (0.8 * size.z() - pot));
    const double reach = radius * random.Uniform(0.7, 0.97) * (1 - 0.5 * share * share);
    const double rise = std::min(random.Uniform(-0.15, 0.5) * reach, 0.99 * size.z() - root.z());
    const Vector3d along(reach * std::cos(angle), reach * std::sin(angle), rise);
    const Colour green = random.Uniform(0.75, 1.2) * Colour(0.2, 0.36, 0.16);
    mesh.parts.push_back(Leaf(root, along, 0.35 * reach, Of(Texture::kPlain, green, 0.05, 0.15, random)));
  }
  return mesh;
}

// A disc on a column with a foot, or on four legs.
Mesh RoundTable(const Vector3d& size, const Colour& colour, Random& random) {
  const double radius = 0.5 * std::min(size.x(), size.y()), top = 0.03, low = size.z() - top;
  Mesh mesh;
  mesh.parts.push_back(Cylinder({0, 0, low}, {0, 0, size.z()}, radius, radius, 40, Wood(colour, random)));
  if (random.Uniform(0, 1) < 0.6) {
    mesh.parts.push_back(Cylinder({0, 0, 0.03}, {0, 0, low}, 0.045, 0.04, 20, DarkMetal(random)));
    mesh.parts.push_back(
        Cylinder({0, 0, 0}, {0, 0, 0.03}, 0.6 * radius, 0.55 * radius, 32, DarkMetal(random)));
    return mesh;
  }
  const Material legs = Wood(0.9 * colour, random);
  for (int i = 0; i < 4; ++i) {
    const double angle = (90 * i + 45) * kDegree;
    const Vector3d out(std::cos(angle), std::sin(angle), 0);
    mesh.parts.push_back(Beam(0.8 * radius * out, Vector3d(0.6 * radius * out + Vector3d(0, 0, low)), 2,
                              {0.03, 0.03}, {0.045, 0.045}, legs));
  }
  return mesh;
}

}  // namespace

const std::vector<std::string>& DistractorShapes() {
  static const std::vector<std::string> shapes{"sofa", "stool", "cabinet", "shelf", "plant", "round_table"};
  return shapes;
}

Mesh DistractorMesh(const std::string& shape, const Vector3d& size, const Colour& colour, Random& random) {
  if (shape == "sofa") return Sofa(size, colour, random);
  if (shape == "stool") return Stool(size, colour, random);
  if (shape == "cabinet") return Cabinet(size, colour, random);
  if (shape == "shelf") return Shelf(size, colour, random);
  if (shape == "plant") return Plant(size, colour, random);
  return RoundTable(size, colour, random);
}

Colour DrawDistractorColour(const std::string& shape, Random& random) {
  if (shape == "sofa") return DrawFabric(random).colour;
  if (shape == "plant") return random.Uniform(0.8, 1.1) * Colour(0.62, 0.45, 0.36);
  return random.Uniform(0, 1) < 0.7 ? DrawWood(random).colour : DrawPaint(random).colour;
}

Vector3d DrawDistractorSize(const std::string& shape, Random& random) {
  const auto draw = [&](double low, double high) { return random.Uniform(low, high); };
  if (shape == "sofa") return {draw(1.3, 2.1), draw(0.78, 0.95), draw(0.72, 0.88)};
  if (shape == "cabinet") return {draw(0.6, 1.4), draw(0.38, 0.5), draw(0.7, 1.3)};
  if (shape == "shelf") return {draw(0.6, 1.2), draw(0.28, 0.36), draw(1.1, 2.0)};
  const double wide = shape == "stool"   ? draw(0.32, 0.4)
                      : shape == "plant" ? draw(0.5, 0.8)
                                         : draw(0.7, 1.15);
  const double high = shape == "stool"   ? draw(0.43, 0.7)
                      : shape == "plant" ? draw(0.8, 1.6)
                                         : draw(0.7, 0.76);
  return {wide, wide, high};
}

}  // namespace armature
