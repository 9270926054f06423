// SPDX-License-Identifier: BSD-3-Clause
#include "category/category_model.h"

namespace armature {

Eigen::VectorXd ShapeVector(const Wireframe& wireframe) {
  Eigen::VectorXd shape(6 * wireframe.edges());
  for (int i = 0; i < wireframe.edges(); ++i) {
    shape.segment<3>(6 * i) = wireframe.midpoints.col(i);
    shape.segment<3>(6 * i + 3) = wireframe.directions.col(i);
  }
  return shape;
}

Wireframe WireframeFromVector(const Eigen::VectorXd& shape) {
  const Eigen::Index m = shape.size() / 6;
  Wireframe wireframe{Eigen::Matrix3Xd(3, m), Eigen::Matrix3Xd(3, m)};
  for (Eigen::Index i = 0; i < m; ++i) {
    wireframe.midpoints.col(i) = shape.segment<3>(6 * i);
    wireframe.directions.col(i) = shape.segment<3>(6 * i + 3);
  }
  return wireframe;
}

Wireframe WireframeFromCoefficients(const CategoryModel& model, const Eigen::VectorXd& coefficients) {
  const Eigen::Index n = coefficients.size();
  return WireframeFromVector(model.mean + model.basis.leftCols(n) *
                                              model.standard_deviations.head(n).cwiseProduct(coefficients));
}

Eigen::VectorXd CoefficientsFromWireframe(const CategoryModel& model, const Wireframe& wireframe) {
  return (model.basis.transpose() * (ShapeVector(wireframe) - model.mean))
      .cwiseQuotient(model.standard_deviations);
}

Eigen::Vector3d BoundingBoxSize(const Wireframe& wireframe) {
  const Eigen::Matrix3Xd half = wireframe.directions.cwiseAbs() / 2;
  return (wireframe.midpoints + half).rowwise().maxCoeff() -
         (wireframe.midpoints - half).rowwise().minCoeff();
}

}  // namespace armature
