// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/scene/clutter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "datasets/cad/solids.h"
#include "datasets/scene/distractors.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

const Colour kPaper(0.88, 0.87, 0.83);

unsigned TextureSeed(Random& random) { return static_cast<unsigned>(random.Uniform(0, 1e6)); }

Material Painted(const Colour& colour, Random& random) {
  return {Texture::kPlain, colour, 0.85 * colour, 0.1, 0.1, TextureSeed(random)};
}

// A block on z = `low`, its centre above `centre`, turned with the frame.
Part Layer(const Isometry3d& frame, const Vector2d& centre, const Vector2d& size, double low, double high,
           const Material& material) {
  const Isometry3d T_mesh_part = frame * Eigen::Translation3d(centre.x(), centre.y(), 0.5 * (low + high));
  return Block(T_mesh_part, {size.x(), size.y(), high - low}, material);
}

Mesh Cardboard(const Vector3d& size, const Colour& colour, Random& random) {
  const Isometry3d frame = Isometry3d::Identity();
  const double tape = 0.001;  // metres, above the box
  Mesh mesh;
  mesh.parts.push_back(Layer(frame, {0, 0}, size.head<2>(), 0, size.z() - tape, Painted(colour, random)));
  mesh.parts.push_back(Layer(frame, {0, 0}, {size.x(), std::min(0.05, 0.3 * size.y())}, size.z() - tape,
                             size.z(), Painted(0.8 * colour, random)));
  return mesh;
}

// A wall that opens upwards, and a dark disc that its inside is seen as.
Mesh Bin(const Vector3d& size, const Colour& colour, Random& random) {
  constexpr int kSides = 24;
  const double radius = 0.5 * std::min(size.x(), size.y()), bottom = random.Uniform(0.75, 0.95) * radius;
  const double rim = std::min(0.02, 0.1 * size.z());
  const Vector3d shoulder(0, 0, size.z() - rim), top(0, 0, size.z());
  Mesh mesh;
  mesh.parts.push_back(
      Cylinder(Vector3d::Zero(), shoulder, bottom, 0.97 * radius, kSides, Painted(colour, random)));
  mesh.parts.push_back(
      Cylinder(shoulder, top - Vector3d(0, 0, 0.001), radius, radius, kSides, Painted(0.9 * colour, random)));
  mesh.parts.push_back(Cylinder(top - Vector3d(0, 0, 0.001), top, 0.9 * radius, 0.9 * radius, kSides,
                                Painted(0.25 * colour, random)));
  return mesh;
}

// Covers, a spine at -y, and pages that stand back a little.
void AddBook(const Isometry3d& frame, const Vector2d& size, double low, double high, const Colour& colour,
             Random& random, Mesh* mesh) {
  const double cover = std::min(0.003, 0.2 * (high - low)), back = 0.004;
  const Material binding = Painted(colour, random);
  mesh->parts.push_back(Layer(frame, {0, 0}, size, low, low + cover, binding));
  mesh->parts.push_back(Layer(frame, {0, 0}, size, high - cover, high, binding));
  mesh->parts.push_back(
      Layer(frame, {0, 0.5 * (cover - size.y())}, {size.x(), cover}, low + cover, high - cover, binding));
  mesh->parts.push_back(Layer(frame, {0, 0.5 * (cover - back)}, size - Vector2d(2 * back, cover + back),
                              low + cover, high - cover, Painted(kPaper, random)));
}

Mesh Books(const Vector3d& size, const Colour& colour, Random& random) {
  const int count = std::max(1, static_cast<int>(std::lround(size.z() / 0.03)));
  const double thickness = size.z() / count;
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const double yaw = count > 1 ? random.Uniform(-4, 4) * kDegree : 0;
    const double share = count > 1 ? random.Uniform(0.78, 0.88) : 1;
    const Colour own = i == 0 ? colour : DrawClutterColour("books", random);
    AddBook(Isometry3d(Eigen::AngleAxisd(yaw, Vector3d::UnitZ())), share * size.head<2>(), i * thickness,
            (i + 1) * thickness, own, random, &mesh);
  }
  return mesh;
}

Mesh Sheets(const Vector3d& size, const Colour& colour, Random& random) {
  const Material print{Texture::kPrint, colour, {0.25, 0.25, 0.27}, 0.008, 0, TextureSeed(random)};
  return {{Layer(Isometry3d::Identity(), {0, 0}, size.head<2>(), 0, size.z(), print)}};
}

Colour PickOne(const std::array<Colour, 5>& colours, Random& random) {
  const Colour& colour = colours[static_cast<size_t>(random.Uniform(0, 5))];
  return random.Uniform(0.85, 1.1) * colour;
}

}  // namespace

const std::vector<std::string>& ClutterShapes() {
  static const std::vector<std::string> shapes = [] {
    std::vector<std::string> all{"box", "cylinder", "books", "paper"};
    all.insert(all.end(), DistractorShapes().begin(), DistractorShapes().end());
    return all;
  }();
  return shapes;
}

bool IsDistractor(const std::string& shape) {
  const std::vector<std::string>& shapes = DistractorShapes();
  return std::find(shapes.begin(), shapes.end(), shape) != shapes.end();
}

Mesh ClutterMesh(const std::string& shape, const Vector3d& size, const Colour& colour, Random& random) {
  if (shape == "cylinder") return Bin(size, colour, random);
  if (shape == "books") return Books(size, colour, random);
  if (shape == "paper") return Sheets(size, colour, random);
  if (IsDistractor(shape)) return DistractorMesh(shape, size, colour, random);
  return Cardboard(size, colour, random);
}

Colour DrawClutterColour(const std::string& shape, Random& random) {
  using Colours = std::array<Colour, 5>;
  if (shape == "paper") return kPaper;
  if (IsDistractor(shape)) return DrawDistractorColour(shape, random);
  if (shape == "books") {
    return PickOne(Colours{Colour(0.5, 0.22, 0.2), Colour(0.2, 0.3, 0.45), Colour(0.25, 0.38, 0.28),
                           Colour(0.72, 0.66, 0.52), Colour(0.28, 0.26, 0.26)},
                   random);
  }
  if (shape == "cylinder") {
    return PickOne(Colours{Colour(0.3, 0.31, 0.33), Colour(0.62, 0.62, 0.6), Colour(0.45, 0.5, 0.42),
                           Colour(0.55, 0.42, 0.34), Colour(0.3, 0.36, 0.46)},
                   random);
  }
  return PickOne(Colours{Colour(0.66, 0.52, 0.36), Colour(0.6, 0.47, 0.33), Colour(0.74, 0.71, 0.66),
                         Colour(0.45, 0.47, 0.5), Colour(0.7, 0.56, 0.38)},
                 random);
}

}  // namespace armature
