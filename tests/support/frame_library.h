// SPDX-License-Identifier: BSD-3-Clause
// Libraries of the frames of category_examples.h.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "retrieval/instance_library.h"
#include "support/category_examples.h"

namespace armature::testing {

// Columns of three coefficients, no two alike, within two standard deviations.
inline Eigen::MatrixXd SomeCoefficients(int count) {
  return Eigen::MatrixXd::NullaryExpr(3, count, [](Eigen::Index mode, Eigen::Index i) {
    return 2 * std::sin(static_cast<double>(3 * i + mode * mode) + 0.4);
  });
}

// A frame in metres with these coefficients, in a box that is 10 cm larger on all sides.
inline CadModel MetricFrame(const std::string& instance, const Eigen::VectorXd& coefficients) {
  CadModel cad;
  cad.instance = instance;
  cad.category = "frame";
  cad.metric = true;
  cad.wireframe = WireframeFromCoefficients(FrameModel(), coefficients);
  const Eigen::Vector3d half = BoundingBoxSize(cad.wireframe) / 2 + Eigen::Vector3d::Constant(0.1);
  cad.box_min = -half;
  cad.box_max = half;
  cad.geometry = "mesh/" + instance + ".ply";
  cad.T_annotation_geometry = Eigen::Affine3d::Identity();
  return cad;
}

// Frames "f0", "f1" and so on, one of each column of coefficients.
inline CategoryInstances FrameInstances(const Eigen::MatrixXd& coefficients) {
  std::vector<CadModel> cad;
  for (Eigen::Index i = 0; i < coefficients.cols(); ++i)
    cad.push_back(MetricFrame(fmt::format("f{}", i), coefficients.col(i)));
  return BuildLibrary({FrameModel()}, cad, "cad").categories.front();
}

}  // namespace armature::testing
