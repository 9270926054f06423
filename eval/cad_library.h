// SPDX-License-Identifier: BSD-3-Clause
// The annotated edges of the CAD models that a sequence's objects are made of. For evaluation only.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "eval/ground_truth.h"

namespace armature {

// A CAD model's edges and bounding box in the axes of the object frame, unit and origin of the annotations.
struct CadModel {
  Wireframe wireframe;
  Eigen::Vector3d box_min{0, 0, 0}, box_max{0, 0, 0};
};

class CadLibrary {
 public:
  // Without any model: no object has known edges.
  CadLibrary() = default;

  // Reads what is there of (file: instances, format):
  //   keypointnet_chair_kp10.csv:       keypointnet:MODEL_ID       boxes in keypointnet_chair_boxes.txt
  //   shapeassembly_table_kp12.csv:     shapeassembly:ANNO_ID      boxes in shapeassembly_table_boxes.txt
  //   modelnet40_laptop_autokp6.csv:    modelnet40:FILE
  //   instances.csv:                    armature:ID                see generated_cad.h
  // A model without boxes takes its annotated edges' bounding box. Throws InputError: none of the files
  // exists, or one is malformed. Categories without specification are left out.
  CadLibrary(const std::filesystem::path& folder, const std::vector<CategorySpec>& specs);

  // The object's own edges in its frame, metres: scaled along each axis so that the CAD model's bounding box
  // gets the object's size, and moved so that the box's centre is the origin. None where the instance is not
  // in the library.
  std::optional<Wireframe> EdgesOf(const TrueObject& object) const;

 private:
  std::map<std::string, CadModel> models_;  // by instance
};

// A box (any origin, any unit) brought to the given size and centred at the origin, with the wireframe in it.
Wireframe FittedToSize(const CadModel& model, const Eigen::Vector3d& size);

}  // namespace armature
