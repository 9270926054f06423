// SPDX-License-Identifier: BSD-3-Clause
// Simple bodies as triangles, without colours.
#pragma once

#include <Eigen/Geometry>

#include "geometry/triangle_mesh.h"

namespace armature {

// 12 triangles; the columns of `half_axes` lead from the centre to the middles of three faces.
TriangleMesh BoxMesh(const Eigen::Vector3d& centre, const Eigen::Matrix3d& half_axes);

// A square bar from a to b, which are different points.
TriangleMesh BarMesh(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double thickness);

// An icosahedron refined to 320 triangles.
TriangleMesh BallMesh(const Eigen::Vector3d& centre, double radius);

}  // namespace armature
