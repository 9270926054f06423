// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/cad/lid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "datasets/cad/edge_ends.h"
#include "datasets/cad/laptop.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Vector3d;

constexpr double kOnPlane = 1e-9;  // metres

Vector3d Midpoint(const Wireframe& laptop, const std::string& edge) {
  const std::vector<std::string> names = LaptopEdgeNames();
  return laptop.midpoints.col(std::find(names.begin(), names.end(), edge) - names.begin());
}

double DistanceFromRay(const Vector3d& point, const Vector3d& direction) {
  return (point - std::max(0.0, point.dot(direction)) * direction).norm();
}

class Hinge {
 public:
  explicit Hinge(const Wireframe& laptop)
      : at_(Midpoint(laptop, "hinge")),
        base_((Midpoint(laptop, "base_front") - at_).normalized()),
        lid_((Midpoint(laptop, "screen_top") - at_).normalized()),
        axis_(base_.cross(lid_).normalized()) {}

  double angle() const { return std::acos(std::clamp(base_.dot(lid_), -1.0, 1.0)); }

  Eigen::Isometry3d Turn(double radians) const {
    return Eigen::Translation3d(at_) * Eigen::AngleAxisd(radians, axis_) * Eigen::Translation3d(-at_);
  }

  bool IsOfLid(const Vector3d& point) const {
    const Vector3d across = Across(point);
    return DistanceFromRay(across, lid_) < DistanceFromRay(across, base_) - kOnPlane;
  }

  bool IsOnAxis(const Vector3d& point) const { return Across(point).norm() < kOnPlane; }

 private:
  Vector3d Across(const Vector3d& point) const { return point - at_ - (point - at_).dot(axis_) * axis_; }

  Vector3d at_, base_, lid_, axis_;
};

bool IsFlat(const Quad& quad) {
  const auto& [a, b, c, d] = quad.corners;
  return std::abs((b - a).cross(c - a).normalized().dot(d - a)) < kOnPlane;
}

// A face of which only a part has turned is two triangles.
void AppendFlat(const Quad& quad, std::vector<Quad>* quads) {
  const auto& [a, b, c, d] = quad.corners;
  if (IsFlat(quad)) {
    quads->push_back(quad);
    return;
  }
  quads->push_back({{a, b, c, c}});
  quads->push_back({{a, c, d, d}});
}

void TurnLid(const Hinge& hinge, const Eigen::Isometry3d& turn, Part* part) {
  std::vector<Quad> quads;
  bool is_lid = true;
  for (Quad quad : part->quads) {
    for (Vector3d& corner : quad.corners) {
      if (hinge.IsOfLid(corner))
        corner = turn * corner;
      else
        is_lid = is_lid && hinge.IsOnAxis(corner);
    }
    AppendFlat(quad, &quads);
  }
  part->quads = std::move(quads);
  if (is_lid) part->T_mesh_part = turn * part->T_mesh_part;  // its texture with it
}

Wireframe WithTurnedScreen(const Wireframe& laptop, const Eigen::Isometry3d& turn) {
  Wireframe turned = laptop;
  const std::vector<std::string> names = LaptopEdgeNames();
  for (size_t i = 0; i < names.size(); ++i) {
    if (!names[i].starts_with("screen_")) continue;
    const auto column = static_cast<Eigen::Index>(i);
    turned.midpoints.col(column) = turn * Vector3d(laptop.midpoints.col(column));
    turned.directions.col(column) = turn.linear() * laptop.directions.col(column);
  }
  return turned;
}

}  // namespace

double LidAngle(const Wireframe& laptop) { return Hinge(laptop).angle() / kDegree; }

CadInstance WithLid(CadInstance laptop, double degrees) {
  const Hinge hinge(laptop.wireframe);
  const Eigen::Isometry3d turn = hinge.Turn(degrees * kDegree - hinge.angle());
  for (Part& part : laptop.mesh.parts) TurnLid(hinge, turn, &part);
  const Eigen::AlignedBox3d box = BoundingBox(laptop.mesh);
  laptop.mesh = Shifted(laptop.mesh, -box.center());
  laptop.wireframe = Shifted(WithTurnedScreen(laptop.wireframe, turn), -box.center());
  laptop.size = box.sizes();
  laptop.lid_deg = degrees;
  return laptop;
}

}  // namespace armature
