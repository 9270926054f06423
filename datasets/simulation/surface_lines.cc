// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulation/surface_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "geometry/random.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Vector3d;

const double kSharp = std::cos(25 * kDegree);  // between the normals of faces that meet in an edge
constexpr double kShortest = 0.004;            // metres: no camera sees what is shorter as a line
constexpr double kPatternLength = 0.18;        // metres, median; its logarithm has a deviation of 0.7

std::vector<Vector3d> Corners(const Quad& quad) {
  std::vector<Vector3d> corners(quad.corners.begin(), quad.corners.end());
  if (corners[3] == corners[2]) corners.pop_back();
  return corners;
}

Vector3d NormalOf(const std::vector<Vector3d>& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
}

// Two faces share an edge where its ends are the same points, as floats.
using EndKey = std::array<float, 3>;
EndKey KeyOf(const Vector3d& point) {
  return {static_cast<float>(point.x()), static_cast<float>(point.y()), static_cast<float>(point.z())};
}

struct FaceEdge {
  Vector3d p1, p2;
  std::vector<Vector3d> normals;
};

// In the order in which the part has them.
std::vector<FaceEdge> EdgesOf(const Part& part) {
  std::vector<FaceEdge> edges;
  std::map<std::array<EndKey, 2>, size_t> known;
  for (const Quad& quad : part.quads) {
    const std::vector<Vector3d> corners = Corners(quad);
    const Vector3d normal = NormalOf(corners);
    for (size_t i = 0; i < corners.size(); ++i) {
      const Vector3d &p1 = corners[i], &p2 = corners[(i + 1) % corners.size()];
      if ((p2 - p1).norm() < kShortest) continue;
      std::array<EndKey, 2> key{KeyOf(p1), KeyOf(p2)};
      if (key[1] < key[0]) std::swap(key[0], key[1]);
      const auto [at, is_new] = known.emplace(key, edges.size());
      if (is_new) edges.push_back({p1, p2, {}});
      edges[at->second].normals.push_back(normal);
    }
  }
  return edges;
}

void AddEdges(const Part& part, const Eigen::Isometry3d& T_world_mesh, Random& random,
              std::vector<SurfaceLine>& lines) {
  for (const FaceEdge& edge : EdgesOf(part)) {
    const Vector3d normal1 = T_world_mesh.linear() * edge.normals.front();
    const Vector3d normal2 = T_world_mesh.linear() * edge.normals.back();
    const bool is_sharp = edge.normals.size() != 2 || normal1.dot(normal2) < kSharp;
    const double contrast = random.Normal(0, 1);
    if (!is_sharp && normal1.dot(normal2) > 1 - 1e-9) continue;  // within one plane
    lines.push_back({T_world_mesh * edge.p1, T_world_mesh * edge.p2, normal1, normal2, is_sharp, contrast});
  }
}

// How many lines of a pattern there are, of those of wood: painted walls have hardly any.
double PatternShare(Texture texture) {
  switch (texture) {
    case Texture::kPlain:
      return 0.15;
    case Texture::kCarpet:
      return 0.5;
    case Texture::kFabric:
      return 0.7;
    case Texture::kWood:
      return 1;
    case Texture::kTiles:
    case Texture::kBoards:
      return 2;
    case Texture::kPrint:
    case Texture::kPicture:
    case Texture::kScreen:
    case Texture::kKeyboard:
      return 10;
  }
  return 1;
}

// Along one of the face's sides, where the pattern's lines mostly run.
void AddPatterns(const Quad& quad, const Eigen::Isometry3d& T_world_mesh, double per_m2, Random& random,
                 std::vector<SurfaceLine>& lines) {
  const std::vector<Vector3d> corners = Corners(quad);
  if (corners.size() < 4) return;
  const Vector3d side_u = corners[1] - corners[0], side_v = corners[3] - corners[0];
  const double expected = per_m2 * side_u.cross(side_v).norm();
  const int count = static_cast<int>(expected + random.Uniform(0, 1));
  for (int i = 0; i < count; ++i) {
    const double u = random.Uniform(0, 1), v = random.Uniform(0, 1);
    const bool along_u = random.Uniform(0, 1) < 0.5;
    const Vector3d& side = along_u ? side_u : side_v;
    const double length = kPatternLength * std::exp(random.Normal(0, 0.7)) / side.norm();
    const double from = std::clamp((along_u ? u : v) - 0.5 * length, 0.0, 1.0);
    const double to = std::clamp((along_u ? u : v) + 0.5 * length, 0.0, 1.0);
    const Vector3d across = along_u ? Vector3d(v * side_v) : Vector3d(u * side_u);
    const Vector3d normal = T_world_mesh.linear() * NormalOf(corners);
    lines.push_back({T_world_mesh * (corners[0] + across + from * side),
                     T_world_mesh * (corners[0] + across + to * side), normal, normal, true,
                     random.Normal(0, 1)});
  }
}

}  // namespace

std::vector<SurfaceLine> FindSurfaceLines(const std::vector<PlacedMesh>& meshes, double patterns_per_m2,
                                          std::uint64_t seed) {
  Random random(seed);
  std::vector<SurfaceLine> lines;
  for (const PlacedMesh& placed : meshes) {
    for (const Part& part : placed.mesh.parts) {
      AddEdges(part, placed.T_world_mesh, random, lines);
      for (const Quad& quad : part.quads)
        AddPatterns(quad, placed.T_world_mesh, patterns_per_m2 * PatternShare(part.material.texture), random,
                    lines);
    }
  }
  return lines;
}

}  // namespace armature
