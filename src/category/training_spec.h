// SPDX-License-Identifier: BSD-3-Clause
// How a category's annotated models become a training set: the `training` section of a category's
// specification.
#pragma once

#include <Eigen/Core>
#include <limits>

#include "category/category_model.h"

namespace armature {

// Sizes of the wireframe's bounding box that an object of the category may have, both ends included.
struct PlausibleSize {
  Eigen::Vector3d min{0, 0, 0};  // along x, y, z, metres
  Eigen::Vector3d max = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());

  bool Contains(const Eigen::Vector3d& size) const {
    return (size.array() >= min.array()).all() && (size.array() <= max.array()).all();
  }
};

struct TrainingSpec {
  CategorySpec category;
  PlausibleSize plausible;
  int modes = 7;         // B, the size of the basis; the paper's number
  bool mirrored = true;  // learn from each model and its mirror image in x
};

}  // namespace armature
