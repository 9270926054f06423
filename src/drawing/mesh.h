// SPDX-License-Identifier: BSD-3-Clause
// What is rendered: parts made of quads, each part of one material with a texture of its own.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace armature {

using Colour = Eigen::Vector3d;  // red, green, blue, 0..1, as one picks it in a drawing program (sRGB)

// Procedural: a function of the point in the part's frame, so that no picture or unwrapping is needed.
enum class Texture {
  kPlain,     // barely visible unevenness, as painted walls have
  kWood,      // grain along the part's x axis
  kFabric,    // a weave
  kCarpet,    // pile
  kTiles,     // square tiles, joints of the second colour, in the part's x-y plane
  kBoards,    // floor boards along the part's x axis in its x-y plane
  kPrint,     // lines of print on paper, x-y plane
  kPicture,   // a painting, x-y plane
  kScreen,    // a lit screen with windows, x-y plane
  kKeyboard,  // rows of keys, x-y plane
};

struct Material {
  Texture texture = Texture::kPlain;
  Colour colour{0.5, 0.5, 0.5};
  Colour second{0.4, 0.4, 0.4};  // of grain, joints, ink
  double scale = 0.1;            // metres: a tile, a board's width, a row of keys, the distance of grains
  double gloss = 0;              // 0: matt, 1: polished
  unsigned seed = 0;             // tells two parts of one material apart
};

// Counter-clockwise seen from outside; flat, convex; the last two corners of a triangle are the same point.
struct Quad {
  std::array<Eigen::Vector3d, 4> corners;  // metres, frame of the mesh
};

struct Part {
  Material material;
  Eigen::Isometry3d T_mesh_part = Eigen::Isometry3d::Identity();  // the frame that the texture is drawn in
  std::vector<Quad> quads;
};

struct Mesh {
  std::vector<Part> parts;
};

Eigen::AlignedBox3d BoundingBox(const Mesh& mesh);

// The mesh shifted; its textures move with it.
Mesh Shifted(const Mesh& mesh, const Eigen::Vector3d& shift);

// With the materials' colours. Corners of a part that are the same point (as floats) are one vertex.
TriangleMesh MakeTriangles(const Mesh& mesh);

}  // namespace armature
