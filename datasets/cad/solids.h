// SPDX-License-Identifier: BSD-3-Clause
// Solids that furniture, rooms and clutter are built of. Metres, in the frame of the mesh.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "drawing/mesh.h"

namespace armature {

// A box with sides along the axes of `T_mesh_part`, whose origin is its centre. Grain runs along x.
Part Block(const Eigen::Isometry3d& T_mesh_part, const Eigen::Vector3d& size, const Material& material);

// The same with its sides along the mesh's axes, between two opposite corners. Grain runs along the longest
// side.
Part Block(const Eigen::Vector3d& low, const Eigen::Vector3d& high, const Material& material);

// A rectangle's width and depth.
using CrossSection = Eigen::Vector2d;

// A straight, possibly tapered beam. The rectangles at its two ends lie in planes of constant `axis` (0: x,
// 1: y, 2: z) through `from` and `to`, with their sides along the two other axes of the mesh (in order): legs
// that are splayed or raked still stand flat on the floor. Grain runs along the beam.
Part Beam(const Eigen::Vector3d& from, const Eigen::Vector3d& to, int axis, const CrossSection& at_from,
          const CrossSection& at_to, const Material& material);

// A cylinder or cone with flat ends at right angles to its axis; `sides`: 3 or more. Grain runs along the
// axis.
Part Cylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius_from, double radius_to,
              int sides, const Material& material);

// The same, possibly inclined, with ends in planes of constant y: a round leg that stands flat on the floor.
Part Pole(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double radius_low, double radius_high,
          int sides, const Material& material);

// Between two flat, convex outlines, one above the other, whose sides are parallel; corners counter-clockwise
// seen from above. Grain runs along their first side.
Part Slab(const std::array<Eigen::Vector3d, 4>& lower, const std::array<Eigen::Vector3d, 4>& upper,
          const Material& material);

}  // namespace armature
