// SPDX-License-Identifier: BSD-3-Clause
#include "category/learn.h"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>

#include "base/errors.h"
#include "category/dictionary.h"
#include "category/normalise.h"

namespace armature {
namespace {

constexpr double kSmallestDeviation = 1e-6;  // metres; modes below are numerical noise
constexpr double kRounding = 1e-12;

void CheckWireframes(const CategorySpec& spec, const std::vector<Wireframe>& wireframes) {
  if (wireframes.size() < 2) {
    throw InputError(
        fmt::format("category {}: {} plausible models, at least 2 are needed; give more models or widen "
                    "training.plausible",
                    spec.name, wireframes.size()));
  }
  for (const Wireframe& wireframe : wireframes) {
    if (wireframe.edges() != spec.edges()) {
      throw InputError(fmt::format("category {}: a model has {} edges where the specification has {}",
                                   spec.name, wireframe.edges(), spec.edges()));
    }
  }
}

Eigen::MatrixXd ShapeMatrix(const std::vector<Wireframe>& wireframes) {
  Eigen::MatrixXd shapes(6 * wireframes.front().edges(), static_cast<Eigen::Index>(wireframes.size()));
  for (size_t i = 0; i < wireframes.size(); ++i) {
    shapes.col(static_cast<Eigen::Index>(i)) = ShapeVector(wireframes[i]);
  }
  return shapes;
}

// Turns each column so that its component of largest magnitude is positive.
Eigen::MatrixXd WithFixedSigns(Eigen::MatrixXd basis) {
  for (Eigen::Index i = 0; i < basis.cols(); ++i) {
    Eigen::Index row = 0;
    basis.col(i).cwiseAbs().maxCoeff(&row);
    if (basis(row, i) < 0) basis.col(i) *= -1;
  }
  return basis;
}

// Exact zeros where symmetry makes them, instead of rounding that differs between machines.
Eigen::MatrixXd WithoutRounding(const Eigen::MatrixXd& numbers) {
  return (numbers.array().abs() < kRounding).select(0.0, numbers);
}

void FitSubspace(const Eigen::MatrixXd& shapes, int modes, CategoryModel& model) {
  model.mean = WithoutRounding(shapes.rowwise().mean());
  const Eigen::MatrixXd centred = shapes.colwise() - model.mean;
  const double freedom = static_cast<double>(shapes.cols() - 1);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(centred, Eigen::ComputeThinU);
  const Eigen::VectorXd deviations = svd.singularValues() / std::sqrt(freedom);
  const Eigen::Index rank = (deviations.array() > kSmallestDeviation).count();
  if (rank == 0)
    throw InputError(fmt::format("category {}: all models have the same shape", model.spec.name));
  const Eigen::Index kept = std::min<Eigen::Index>(modes, rank);
  model.basis = WithoutRounding(WithFixedSigns(svd.matrixU().leftCols(kept)));
  model.standard_deviations = deviations.head(kept);
  model.total_variance = deviations.squaredNorm();
}

void ChooseDictionary(const std::vector<Wireframe>& wireframes, CategoryModel& model) {
  Eigen::MatrixXd coefficients(model.modes(), static_cast<Eigen::Index>(wireframes.size()));
  for (size_t i = 0; i < wireframes.size(); ++i) {
    coefficients.col(static_cast<Eigen::Index>(i)) = CoefficientsFromWireframe(model, wireframes[i]);
  }
  const Eigen::MatrixXd metric = model.standard_deviations.asDiagonal() * coefficients;
  for (const int medoid : KMedoids(metric, model.spec.dictionary_size).medoids) {
    model.dictionary.push_back(coefficients.col(medoid));
  }
}

}  // namespace

std::vector<Wireframe> TrainingSet(const TrainingSpec& spec, const std::vector<Wireframe>& wireframes) {
  std::vector<Wireframe> training = wireframes;
  if (!spec.mirrored) return training;
  for (const Wireframe& wireframe : wireframes) training.push_back(Mirrored(spec.category, wireframe));
  return training;
}

CategoryModel LearnCategory(const TrainingSpec& spec, const std::vector<Wireframe>& wireframes,
                            const std::string& source) {
  CheckWireframes(spec.category, wireframes);
  CategoryModel model;
  model.spec = spec.category;
  model.source = source;
  model.training_models = static_cast<int>(wireframes.size());
  FitSubspace(ShapeMatrix(TrainingSet(spec, wireframes)), spec.modes, model);
  ChooseDictionary(wireframes, model);
  return model;
}

Eigen::VectorXd ExplainedVariance(const CategoryModel& model) {
  return model.standard_deviations.cwiseAbs2() / model.total_variance;
}

}  // namespace armature
