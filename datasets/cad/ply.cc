// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/cad/ply.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace armature {
namespace {

struct Triangle {
  std::array<std::uint32_t, 3> vertices;
  std::array<std::uint8_t, 3> colour;
};

struct Triangles {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<Triangle> faces;
};

// Index of the vertex among those from `first` on; adds it where it is new.
std::uint32_t VertexIndex(const Eigen::Vector3f& vertex, size_t first, Triangles& triangles) {
  for (size_t i = first; i < triangles.vertices.size(); ++i) {
    if (triangles.vertices[i] == vertex) return static_cast<std::uint32_t>(i);
  }
  triangles.vertices.push_back(vertex);
  return static_cast<std::uint32_t>(triangles.vertices.size() - 1);
}

std::array<std::uint8_t, 3> Bytes(const Colour& colour) {
  const auto byte = [](double share) { return static_cast<std::uint8_t>(std::lround(255 * share)); };
  return {byte(colour.x()), byte(colour.y()), byte(colour.z())};
}

void AddPart(const Part& part, Triangles& triangles) {
  const size_t first = triangles.vertices.size();
  const std::array<std::uint8_t, 3> colour = Bytes(part.material.colour);
  for (const Quad& quad : part.quads) {
    std::array<std::uint32_t, 4> v;
    for (size_t i = 0; i < 4; ++i) v[i] = VertexIndex(quad.corners[i].cast<float>(), first, triangles);
    triangles.faces.push_back({{v[0], v[1], v[2]}, colour});
    if (v[3] != v[2]) triangles.faces.push_back({{v[0], v[2], v[3]}, colour});
  }
}

// Least significant byte first, whatever the machine.
void Append(std::uint32_t number, std::string& bytes) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((number >> shift) & 0xFF);
}

}  // namespace

std::string PlyText(const Mesh& mesh) {
  Triangles triangles;
  for (const Part& part : mesh.parts) AddPart(part, triangles);
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment metres, y up, front +z\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "element face {}\nproperty list uchar int vertex_indices\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
      triangles.vertices.size(), triangles.faces.size());
  for (const Eigen::Vector3f& vertex : triangles.vertices) {
    for (const float coordinate : vertex) Append(std::bit_cast<std::uint32_t>(coordinate), bytes);
  }
  for (const Triangle& face : triangles.faces) {
    bytes += '\3';
    for (const std::uint32_t vertex : face.vertices) Append(vertex, bytes);
    for (const std::uint8_t channel : face.colour) bytes += static_cast<char>(channel);
  }
  return bytes;
}

}  // namespace armature
