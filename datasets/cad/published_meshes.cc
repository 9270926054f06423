// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/cad/published_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <tuple>
#include <vector>

#include "base/errors.h"
#include "base/text.h"
#include "datasets/cad/materials.h"
#include "datasets/cad/solids.h"
#include "drawing/ray_scene.h"
#include "drawing/sampling.h"
#include "io/box_table.h"

namespace armature {
namespace {

using Eigen::Vector3d;

constexpr double kSlender = 0.09;    // metres: two sides of legs, rails, posts are less
constexpr double kThinnest = 0.002;  // metres: boxes without thickness would be seen through

const Material& MaterialFor(Vector3d size, const FurnitureMaterials& materials) {
  std::sort(size.data(), size.data() + 3);
  return size[1] < kSlender ? materials.frame : materials.body;
}

// Grain runs along the longest side, and the x-y plane is the largest face.
Part BoxPart(const TableBox& box, const Eigen::Affine3d& T_object_file, const FurnitureMaterials& materials,
             unsigned seed) {
  const Eigen::Matrix3d half_axes = T_object_file.linear() * box.half_axes;
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return half_axes.col(a).norm() > half_axes.col(b).norm(); });
  Vector3d size;
  for (size_t i = 0; i < 3; ++i)
    size[static_cast<Eigen::Index>(i)] = std::max(kThinnest, 2 * half_axes.col(order[i]).norm());
  Eigen::Isometry3d T_object_part = Eigen::Isometry3d::Identity();
  const Vector3d x = half_axes.col(order[0]).normalized(), z = x.cross(half_axes.col(order[1])).normalized();
  T_object_part.linear() << x, z.cross(x), z;
  T_object_part.translation() = T_object_file * box.centre;
  Material material = MaterialFor(size, materials);
  material.seed = seed;
  return Block(T_object_part, size, material);
}

// Which piece each triangle belongs to, from 0: neighbours have a corner in common, as points are.
std::vector<int> FindPieces(const TriangleMesh& mesh) {
  std::vector<int> parent;
  const auto find = [&](int i) {
    while (parent[static_cast<size_t>(i)] != i) i = parent[static_cast<size_t>(i)];
    return i;
  };
  std::map<std::tuple<long, long, long>, int> points;
  std::vector<int> point_of(static_cast<size_t>(mesh.vertices.cols()));
  for (Eigen::Index v = 0; v < mesh.vertices.cols(); ++v) {
    const Eigen::Array3d micrometres = (1e6 * mesh.vertices.col(v)).array().round();
    const std::tuple<long, long, long> key(static_cast<long>(micrometres[0]),
                                           static_cast<long>(micrometres[1]),
                                           static_cast<long>(micrometres[2]));
    const auto [point, is_new] = points.try_emplace(key, static_cast<int>(parent.size()));
    if (is_new) parent.push_back(point->second);
    point_of[static_cast<size_t>(v)] = point->second;
  }
  for (Eigen::Index t = 0; t < mesh.size(); ++t) {
    const int root = find(point_of[static_cast<size_t>(mesh.triangles(0, t))]);
    for (const int corner : {1, 2}) {
      parent[static_cast<size_t>(find(point_of[static_cast<size_t>(mesh.triangles(corner, t))]))] = root;
    }
  }
  std::vector<int> pieces;
  for (Eigen::Index t = 0; t < mesh.size(); ++t)
    pieces.push_back(find(point_of[static_cast<size_t>(mesh.triangles(0, t))]));
  return pieces;
}

Quad TriangleQuad(const TriangleMesh& mesh, Eigen::Index t) {
  std::array<Vector3d, 3> corners;
  for (int i = 0; i < 3; ++i) corners[static_cast<size_t>(i)] = mesh.vertices.col(mesh.triangles(i, t));
  return {{corners[0], corners[1], corners[2], corners[2]}};
}

Vector3d Normal(const Quad& quad) {
  const auto& c = quad.corners;
  return (c[1] - c[0]).cross(c[2] - c[0]).normalized();
}

// How many of some rays to that side get away.
int CountEscapes(const RayScene& rays, const Vector3d& point, const Vector3d& normal) {
  static const std::vector<Eigen::Vector2d> kPlaces = SpreadPlaces(16);
  const Eigen::Matrix3d axes = AxesAround(normal);
  int escapes = 0;
  for (const Eigen::Vector2d& place : kPlaces) {
    const RayHit hit = rays.Nearest(point + 1e-4 * normal, HemisphereDirection(place, axes));
    escapes += hit.mesh < 0 ? 1 : 0;
  }
  return escapes;
}

// Each triangle faces the side from which more of the world is seen.
void TurnOutwards(Mesh* mesh) {
  const RayScene rays({{*mesh}});
  for (Part& part : mesh->parts) {
    for (Quad& quad : part.quads) {
      const Vector3d centre = (quad.corners[0] + quad.corners[1] + quad.corners[2]) / 3;
      const Vector3d normal = Normal(quad);
      if (CountEscapes(rays, centre, -normal) > CountEscapes(rays, centre, normal))
        quad.corners = {quad.corners[1], quad.corners[0], quad.corners[2], quad.corners[2]};
    }
  }
}

bool HasArea(const Quad& quad) {
  const auto& c = quad.corners;
  return (c[1] - c[0]).cross(c[2] - c[0]).norm() > 1e-10;
}

Material Coloured(const ColourBytes& bytes) {
  Material material;
  material.colour = bytes.cast<double>() / 255;
  material.second = 0.9 * material.colour;
  material.gloss = 0.1;
  return material;
}

}  // namespace

FurnitureMaterials DrawFurnitureMaterials(const std::string& category, std::uint64_t seed) {
  Random random(seed);
  const double body = random.Uniform(0, 1), frame = random.Uniform(0, 1);
  const Material wood = DrawWood(random), paint = DrawPaint(random), fabric = DrawFabric(random),
                 metal = DrawMetal(random), plastic = DrawPlastic(random);
  if (category == "laptop") return {metal, plastic};
  if (category == "table")
    return {body < 0.7 ? wood : paint, frame < 0.5 ? wood : frame < 0.8 ? metal : paint};
  return {body < 0.35   ? wood
          : body < 0.55 ? plastic
          : body < 0.85 ? fabric
                        : paint,
          frame < 0.55   ? wood
          : frame < 0.85 ? metal
                         : paint};
}

Mesh BoxFurniture(const std::filesystem::path& file, const std::string& id,
                  const Eigen::Affine3d& T_object_file, const FurnitureMaterials& materials) {
  Mesh mesh;
  for (const TextLine& line : ReadTextLines(file)) {
    const TableBox box = ParseTableBox(file, line);
    if (box.ids[0] != id && box.ids[1] != id) continue;
    mesh.parts.push_back(BoxPart(box, T_object_file, materials, static_cast<unsigned>(mesh.parts.size())));
  }
  if (mesh.parts.empty())
    throw InputError(fmt::format("{}: has no box of {}; download it again", file.string(), Quoted(id)));
  return mesh;
}

Mesh TriangleFurniture(const TriangleMesh& mesh, const FurnitureMaterials& materials) {
  const bool has_colours = mesh.colours.cols() == mesh.size();
  const std::vector<int> pieces = FindPieces(mesh);
  std::map<std::tuple<int, int, int, int>, size_t> parts;  // by piece and colour
  Mesh furniture;
  for (Eigen::Index t = 0; t < mesh.size(); ++t) {
    const Quad quad = TriangleQuad(mesh, t);
    if (!HasArea(quad)) continue;
    const ColourBytes colour = has_colours ? ColourBytes(mesh.colours.col(t)) : ColourBytes(0, 0, 0);
    const auto [part, is_new] = parts.try_emplace(
        {pieces[static_cast<size_t>(t)], colour[0], colour[1], colour[2]}, furniture.parts.size());
    if (is_new) {
      furniture.parts.emplace_back();
      if (has_colours) furniture.parts.back().material = Coloured(colour);
    }
    furniture.parts[part->second].quads.push_back(quad);
  }
  unsigned seed = 0;
  for (Part& part : furniture.parts) {
    const Vector3d size = BoundingBox({{part}}).sizes();
    if (!has_colours) part.material = MaterialFor(size, materials);
    part.material.seed = seed++;
  }
  TurnOutwards(&furniture);
  return furniture;
}

}  // namespace armature
