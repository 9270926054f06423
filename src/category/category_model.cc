// SPDX-License-Identifier: BSD-3-Clause
#include "category/category_model.h"

#include <span>

#include "base/checksum.h"

namespace armature {
namespace {

template <typename Matrix>
void AddBytes(const Matrix& matrix, std::vector<double>& all) {
  all.insert(all.end(), matrix.data(), matrix.data() + matrix.size());
}

}  // namespace

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

std::uint64_t ModelChecksum(const CategoryModel& model) {
  std::vector<double> numbers;
  AddBytes(model.mean, numbers);
  AddBytes(model.basis, numbers);
  AddBytes(model.standard_deviations, numbers);
  std::uint64_t sum = Checksum(std::as_bytes(std::span(numbers)));
  for (const std::string& name : model.spec.edge_names)
    sum = 31 * sum + Checksum(std::as_bytes(std::span(name)));
  return sum;
}

Eigen::Vector3d BoundingBoxSize(const Wireframe& wireframe) {
  const Eigen::Matrix3Xd half = wireframe.directions.cwiseAbs() / 2;
  return (wireframe.midpoints + half).rowwise().maxCoeff() -
         (wireframe.midpoints - half).rowwise().minCoeff();
}

}  // namespace armature
