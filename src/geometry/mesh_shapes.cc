// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/mesh_shapes.h"

#include <algorithm>
#include <map>
#include <numbers>

namespace armature {
namespace {

// Every triangle becomes four; the new vertices are pushed out to the unit sphere.
TriangleMesh Refined(const TriangleMesh& ball) {
  TriangleMesh finer{ball.vertices, Eigen::Matrix3Xi(3, 4 * ball.size()), {}};
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto vertices = static_cast<int>(finer.vertices.cols());
    const auto [entry, is_new] = middles.try_emplace(std::minmax(a, b), vertices);
    if (is_new) {
      const Eigen::Vector3d vertex = (ball.vertices.col(a) + ball.vertices.col(b)).normalized();
      finer.vertices.conservativeResize(3, vertices + 1);
      finer.vertices.col(vertices) = vertex;
    }
    return entry->second;
  };
  for (Eigen::Index i = 0; i < ball.size(); ++i) {
    const Eigen::Vector3i v = ball.triangles.col(i);
    const int ab = middle(v[0], v[1]), bc = middle(v[1], v[2]), ca = middle(v[2], v[0]);
    finer.triangles.middleCols<4>(4 * i) << v[0], ab, ca, ab,  //
        ab, v[1], bc, bc,                                      //
        ca, bc, v[2], ca;
  }
  return finer;
}

TriangleMesh UnitIcosahedron() {
  const double g = std::numbers::phi;
  TriangleMesh mesh{Eigen::Matrix3Xd(3, 12), Eigen::Matrix3Xi(3, 20), {}};
  mesh.vertices << -1, 1, -1, 1, 0, 0, 0, 0, g, g, -g, -g,  //
      g, g, -g, -g, -1, 1, -1, 1, 0, 0, 0, 0,               //
      0, 0, 0, 0, g, g, -g, -g, -1, 1, -1, 1;
  mesh.vertices.colwise().normalize();
  mesh.triangles << 0, 0, 0, 0, 0, 1, 5, 11, 10, 7, 3, 3, 3, 3, 3, 4, 2, 6, 8, 9,  //
      11, 5, 1, 7, 10, 5, 11, 10, 7, 1, 9, 4, 2, 6, 8, 9, 4, 2, 6, 8,              //
      5, 1, 7, 10, 11, 9, 4, 2, 6, 8, 4, 2, 6, 8, 9, 5, 11, 10, 7, 1;
  return mesh;
}

}  // namespace

TriangleMesh BoxMesh(const Eigen::Vector3d& centre, const Eigen::Matrix3d& half_axes) {
  TriangleMesh mesh{Eigen::Matrix3Xd(3, 8), Eigen::Matrix3Xi(3, 12), {}};
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : -1);
    mesh.vertices.col(i) = centre + half_axes * corner;
  }
  mesh.triangles << 0, 0, 4, 4, 0, 0, 2, 2, 0, 0, 1, 1,  //
      2, 3, 5, 7, 1, 5, 6, 7, 4, 6, 3, 7,                //
      3, 1, 7, 6, 5, 4, 7, 3, 6, 2, 7, 5;
  return mesh;
}

TriangleMesh BarMesh(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double thickness) {
  Eigen::Matrix3d half_axes;
  half_axes.col(0) = (b - a) / 2;
  half_axes.col(1) = thickness / 2 * (b - a).unitOrthogonal();
  half_axes.col(2) = half_axes.col(0).normalized().cross(half_axes.col(1));
  return BoxMesh((a + b) / 2, half_axes);
}

TriangleMesh BallMesh(const Eigen::Vector3d& centre, double radius) {
  static const TriangleMesh unit = Refined(Refined(UnitIcosahedron()));
  TriangleMesh mesh = unit;
  mesh.vertices = (radius * unit.vertices).colwise() + centre;
  return mesh;
}

}  // namespace armature
