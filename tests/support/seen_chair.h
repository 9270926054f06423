// SPDX-License-Identifier: BSD-3-Clause
// A chair of known shape, seen without errors by cameras around it.
#pragma once

#include <Eigen/Geometry>

#include "geometry/se3.h"
#include "retrieval/instance_fit.h"
#include "support/map_world.h"

namespace armature::testing {

class SeenChair {
 public:
  explicit SeenChair(double shape = 0.8) {
    world_.Put("chair", 0.2, 2.8, 30, shape);
    for (int i = 0; i < 8; ++i) {
      const double angle = (-50.0 + 14 * i) * kDegree;
      world_.Look(0.2 + 2.6 * std::sin(angle), 2.8 - 2.6 * std::cos(angle), 0.2, 2.8);
    }
  }

  const CategoryModel& model() const { return world_.Model("chair"); }
  const TrueFurniture& truth() const { return world_.furniture.front(); }
  Wireframe TrueWireframe() const { return WireframeFromCoefficients(model(), truth().coefficients); }

  // What a map has of it that is off by a step in the object's frame.
  ObjectSightings Sightings(const Vector6d& wrong = Vector6d::Zero()) const {
    ObjectSightings sightings;
    sightings.frames = world_.Frames({});
    sightings.T_world_camera = world_.T_world_camera;
    sightings.T_world_object = truth().T_world_object * ExpSE3(wrong);
    return sightings;
  }

 private:
  MapWorld world_;
};

// Some centimetres along each axis, and a degree or two about the vertical.
inline Vector6d FewCentimetres() {
  Vector6d wrong;
  wrong << 0, 0.03, 0, 0.03, -0.02, 0.04;
  return wrong;
}

}  // namespace armature::testing
