// SPDX-License-Identifier: BSD-3-Clause
#include "category/set_comparison.h"

#include <fmt/format.h>

#include "base/errors.h"
#include "category/learn.h"

namespace armature {
namespace {

// Of the columns, with the estimate of the deviation that LearnCategory uses.
CoefficientStatistics ColumnStatistics(const Eigen::MatrixXd& coefficients) {
  const Eigen::VectorXd mean = coefficients.rowwise().mean();
  const Eigen::MatrixXd centred = coefficients.colwise() - mean;
  const double freedom = static_cast<double>(coefficients.cols() - 1);
  return {mean, (centred.rowwise().squaredNorm() / freedom).cwiseSqrt()};
}

}  // namespace

SetStatistics ComputeStatistics(const CategoryModel& model, const TrainingSpec& spec,
                                const std::vector<Wireframe>& wireframes) {
  if (wireframes.size() < 2) {
    throw InputError(fmt::format("category {}: {} plausible models to compare with, at least 2 are needed",
                                 spec.category.name, wireframes.size()));
  }
  const std::vector<Wireframe> set = TrainingSet(spec, wireframes);
  Eigen::MatrixXd coefficients(model.modes(), static_cast<Eigen::Index>(set.size()));
  for (size_t i = 0; i < set.size(); ++i) {
    coefficients.col(static_cast<Eigen::Index>(i)) = CoefficientsFromWireframe(model, set[i]);
  }
  return {ColumnStatistics(coefficients), Reconstruct(model, wireframes, model.modes())};
}

}  // namespace armature
