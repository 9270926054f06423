// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/cad/solids.h"

#include <cmath>
#include <numbers>

namespace armature {
namespace {

using Eigen::Vector3d;

using Ring = std::vector<Vector3d>;  // corners of an end, counter-clockwise seen from outside of the far end

// Axes of a frame at `origin` with x along `along`.
Eigen::Isometry3d FrameAlong(const Vector3d& origin, const Vector3d& along) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitX(), along).toRotationMatrix();
  frame.translation() = origin;
  return frame;
}

// Sides between the rings of the near and the far end.
void AddSides(const Ring& near, const Ring& far, Part* part) {
  for (size_t i = 0; i < near.size(); ++i) {
    const size_t j = (i + 1) % near.size();
    part->quads.push_back({{near[i], near[j], far[j], far[i]}});
  }
}

// A flat end, as quads around its first corner; `corners` counter-clockwise seen from outside.
void AddEnd(const Ring& corners, Part* part) {
  for (size_t i = 1; i + 1 < corners.size(); i += 2) {
    const Vector3d& last = corners[std::min(i + 2, corners.size() - 1)];
    part->quads.push_back({{corners[0], corners[i], corners[i + 1], last}});
  }
}

Part Prism(const Ring& near, const Ring& far, const Eigen::Isometry3d& T_mesh_part,
           const Material& material) {
  Part part{material, T_mesh_part, {}};
  AddSides(near, far, &part);
  AddEnd(far, &part);
  AddEnd(Ring(near.rbegin(), near.rend()), &part);
  return part;
}

// Around `centre` in the plane of the directions b and c; b x c points from the near to the far end.
Ring Rectangle(const Vector3d& centre, const Vector3d& half_b, const Vector3d& half_c) {
  return {centre - half_b - half_c, centre + half_b - half_c, centre + half_b + half_c,
          centre - half_b + half_c};
}

Ring Circle(const Vector3d& centre, const Eigen::Matrix3d& axes, double radius, int sides) {
  Ring ring;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    ring.push_back(centre + radius * (std::cos(angle) * axes.col(1) + std::sin(angle) * axes.col(2)));
  }
  return ring;
}

}  // namespace

Part Block(const Eigen::Isometry3d& T_mesh_part, const Vector3d& size, const Material& material) {
  const Eigen::Matrix3d half = T_mesh_part.linear() * (0.5 * size).asDiagonal();
  const Vector3d centre = T_mesh_part.translation();
  return Prism(Rectangle(centre - half.col(0), half.col(1), half.col(2)),
               Rectangle(centre + half.col(0), half.col(1), half.col(2)), T_mesh_part, material);
}

Part Block(const Vector3d& low, const Vector3d& high, const Material& material) {
  const Vector3d size = high - low;
  int longest = 0;
  size.maxCoeff(&longest);
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.translation() = 0.5 * (low + high);
  for (int axis = 0; axis < 3; ++axis) frame.linear().col(axis) = Vector3d::Unit((longest + axis) % 3);
  return Block(frame, frame.linear().transpose() * size, material);
}

Part Beam(const Vector3d& from, const Vector3d& to, int axis, const CrossSection& at_from,
          const CrossSection& at_to, const Material& material) {
  // The section's first side is along b, the lower numbered of the other axes; (b, c, axis) may be
  // left-handed.
  const int b = axis == 0 ? 1 : 0, c = axis == 2 ? 1 : 2;
  const double sense = axis == 1 ? -1 : 1;
  const auto ring = [&](const Vector3d& centre, const CrossSection& section) {
    return Rectangle(centre, 0.5 * section.x() * Vector3d::Unit(b),
                     sense * 0.5 * section.y() * Vector3d::Unit(c));
  };
  const bool forward = to[axis] > from[axis];
  const Ring near = forward ? ring(from, at_from) : ring(to, at_to);
  const Ring far = forward ? ring(to, at_to) : ring(from, at_from);
  return Prism(near, far, FrameAlong(0.5 * (from + to), to - from), material);
}

Part Cylinder(const Vector3d& from, const Vector3d& to, double radius_from, double radius_to, int sides,
              const Material& material) {
  const Eigen::Isometry3d frame = FrameAlong(0.5 * (from + to), to - from);
  return Prism(Circle(from, frame.linear(), radius_from, sides), Circle(to, frame.linear(), radius_to, sides),
               frame, material);
}

Part Pole(const Vector3d& low, const Vector3d& high, double radius_low, double radius_high, int sides,
          const Material& material) {
  Eigen::Matrix3d axes;  // circles in the plane of z and x
  axes << Vector3d::UnitY(), Vector3d::UnitZ(), Vector3d::UnitX();
  return Prism(Circle(low, axes, radius_low, sides), Circle(high, axes, radius_high, sides),
               FrameAlong(0.5 * (low + high), high - low), material);
}

Part Slab(const std::array<Vector3d, 4>& lower, const std::array<Vector3d, 4>& upper,
          const Material& material) {
  Eigen::Isometry3d frame = FrameAlong(Vector3d::Zero(), upper[1] - upper[0]);
  frame.translation() = 0.25 * (upper[0] + upper[1] + upper[2] + upper[3]);
  return Prism(Ring(lower.begin(), lower.end()), Ring(upper.begin(), upper.end()), frame, material);
}

}  // namespace armature
