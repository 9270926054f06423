// SPDX-License-Identifier: BSD-3-Clause
// An annotated CAD model of a collection.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "category/category_model.h"

namespace armature {

struct CadModel {
  std::string instance;   // "armature:chair-0001": as objects_gt.csv names it
  std::string category;   // "chair"
  bool held_out = false;  // kept apart from what category models are learnt from
  bool metric = false;    // in metres; else in any unit
  Wireframe wireframe;    // axes of the object frame, unit and origin of the annotations
  Eigen::Vector3d box_min{0, 0, 0}, box_max{0, 0, 0};  // of the CAD model, in the same frame and unit

  // Its surface: a file relative to the collection's folder, "FILE" or "FILE#ID" (io/mesh_file.h); empty:
  // there is none.
  std::string geometry{};
  // x_annotation = T * x_geometry. None: the mesh and its annotations were brought into different frames.
  std::optional<Eigen::Affine3d> T_annotation_geometry{};
};

}  // namespace armature
