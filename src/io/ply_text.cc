// SPDX-License-Identifier: BSD-3-Clause
#include "io/ply_text.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace armature {
namespace {

constexpr const char* kCoordinates = "property float x\nproperty float y\nproperty float z\n";
constexpr const char* kChannels = "property uchar red\nproperty uchar green\nproperty uchar blue\n";

// Least significant byte first, whatever the machine.
void Append(std::uint32_t number, std::string& bytes) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((number >> shift) & 0xFF);
}

void AppendPoint(const Eigen::Vector3d& point, std::string& bytes) {
  for (const double coordinate : point) {
    Append(std::bit_cast<std::uint32_t>(static_cast<float>(coordinate)), bytes);
  }
}

void AppendColour(const ColourBytes& colour, std::string& bytes) {
  for (const unsigned char channel : colour) bytes += static_cast<char>(channel);
}

void AppendCorners(const Eigen::Vector3i& corners, std::string& bytes) {
  bytes += '\3';
  for (const int corner : corners) Append(static_cast<std::uint32_t>(corner), bytes);
}

ColourBytes FindColour(const TriangleMesh& mesh, Eigen::Index triangle) {
  if (mesh.colours.cols() != mesh.size()) return {160, 160, 160};
  return mesh.colours.col(triangle);
}

struct Vertices {
  std::vector<std::pair<int, ColourBytes>> coloured;  // index in the mesh
  Eigen::Matrix3Xi triangles;                         // indices of `coloured`
};

// Each vertex once for each colour of its triangles, in the order of the triangles.
Vertices ColourVertices(const TriangleMesh& mesh) {
  Vertices vertices{{}, mesh.triangles};
  std::unordered_map<std::uint64_t, int> indices;
  for (Eigen::Index i = 0; i < mesh.size(); ++i) {
    const ColourBytes colour = FindColour(mesh, i);
    for (int& corner : vertices.triangles.col(i)) {
      const auto packed = static_cast<std::uint64_t>(colour[0] << 16 | colour[1] << 8 | colour[2]);
      const std::uint64_t key = static_cast<std::uint64_t>(corner) << 24 | packed;
      const auto [entry, is_new] = indices.try_emplace(key, static_cast<int>(vertices.coloured.size()));
      if (is_new) vertices.coloured.emplace_back(corner, colour);
      corner = entry->second;
    }
  }
  return vertices;
}

std::string Header(const std::string& comment, size_t vertices, const char* vertex_colour,
                   Eigen::Index triangles, const char* triangle_colour) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\n{}{}element face {}\n"
      "property list uchar int vertex_indices\n{}end_header\n",
      comment, vertices, kCoordinates, vertex_colour, triangles, triangle_colour);
}

std::string TextWithColouredVertices(const TriangleMesh& mesh, const std::string& comment) {
  const Vertices vertices = ColourVertices(mesh);
  std::string bytes = Header(comment, vertices.coloured.size(), kChannels, mesh.size(), "");
  for (const auto& [vertex, colour] : vertices.coloured) {
    AppendPoint(mesh.vertices.col(vertex), bytes);
    AppendColour(colour, bytes);
  }
  for (const auto& corners : vertices.triangles.colwise()) AppendCorners(corners, bytes);
  return bytes;
}

std::string TextWithColouredTriangles(const TriangleMesh& mesh, const std::string& comment) {
  std::string bytes = Header(comment, static_cast<size_t>(mesh.vertices.cols()), "", mesh.size(), kChannels);
  for (const auto& vertex : mesh.vertices.colwise()) AppendPoint(vertex, bytes);
  for (Eigen::Index i = 0; i < mesh.size(); ++i) {
    AppendCorners(mesh.triangles.col(i), bytes);
    AppendColour(FindColour(mesh, i), bytes);
  }
  return bytes;
}

}  // namespace

std::string PlyText(const TriangleMesh& mesh, PlyColours colours, const std::string& comment) {
  return colours == PlyColours::kOfVertices ? TextWithColouredVertices(mesh, comment)
                                            : TextWithColouredTriangles(mesh, comment);
}

}  // namespace armature
