// SPDX-License-Identifier: BSD-3-Clause
// Small category data for tests.
#pragma once

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "category/training_spec.h"

namespace armature::testing {

inline std::filesystem::path CategoryFolder() {
  return std::filesystem::path(ARMATURE_SOURCE_DIR) / "configs" / "categories";
}

// Three edges: a frame of a left post, a right post and a bar across; the bar's length is the reference.
inline TrainingSpec FrameSpec() {
  TrainingSpec spec;
  spec.category.name = "frame";
  spec.category.edge_names = {"left", "right", "bar"};
  spec.category.base_edges = {0, 2};
  spec.category.reference = {MetricReference::Measure::kLength, {2}, 1.0};
  spec.modes = 2;
  spec.mirrored = false;
  return spec;
}

// Posts from the rear (z = -1/2) to the front, bar from left to right at the rear.
inline Wireframe FrameWireframe() {
  Wireframe wireframe{Eigen::Matrix3Xd::Zero(3, 3), Eigen::Matrix3Xd::Zero(3, 3)};
  wireframe.midpoints << -0.5, 0.5, 0, 0, 0, 0, 0, 0, -0.5;
  wireframe.directions << 0, 0, 1, 0, 0, 0, 1, 1, 0;
  return wireframe;
}

// Frames that differ in width, in depth and in how far the bar's right end rises; all of them are centred.
inline CategoryModel FrameModel() {
  CategoryModel model;
  model.spec = FrameSpec().category;
  model.mean = ShapeVector(FrameWireframe());
  model.basis = Eigen::MatrixXd::Zero(model.mean.size(), 3);
  const auto mode = [&](Eigen::Index column, Eigen::Index edge) {
    return model.basis.col(column).segment<6>(6 * edge);
  };
  mode(0, 0).x() = -0.5;
  mode(0, 1).x() = 0.5;
  mode(0, 2)(3) = 1;
  mode(1, 0)(5) = mode(1, 1)(5) = 1;
  mode(1, 2).z() = -0.5;
  mode(2, 2)(4) = 1;
  model.basis.colwise().normalize();
  model.standard_deviations = Eigen::Vector3d(0.2, 0.1, 0.05);
  return model;
}

}  // namespace armature::testing
