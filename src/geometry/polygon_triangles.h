// SPDX-License-Identifier: BSD-3-Clause
// Polygons cut into triangles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace armature {

using TriangleCorners = std::array<size_t, 3>;  // indices of a polygon's corners, in its own direction

// Most corners of a polygon that is not convex: cutting it takes the square of their number.
inline constexpr size_t kMostConcaveCorners = 4096;

// At least three corners; nearly in a plane, else they are seen along the polygon's mean normal. A convex
// polygon becomes a fan around its first corner; any other is cut at its ears, corners in a straight line
// left out, also where it touches itself, as at the bridge to a hole. A polygon that crosses itself becomes
// triangles of its corners, with no promise of its area. None when it has too many corners.
std::vector<TriangleCorners> CutPolygon(std::span<const Eigen::Vector3d> corners);

}  // namespace armature
