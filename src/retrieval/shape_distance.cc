// SPDX-License-Identifier: BSD-3-Clause
#include "retrieval/shape_distance.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace armature {
namespace {

constexpr Eigen::Index kBlock = 1024;  // instances that are compared at once

Eigen::Index Kept(Eigen::Index modes, const FeatureOptions& options) {
  return options.modes > 0 ? std::min<Eigen::Index>(modes, options.modes) : modes;
}

// A query's distance: |root (x - mean)|, of the kept modes.
struct Metric {
  Eigen::MatrixXd root;
  Eigen::VectorXd mean;
};

// That of a mode within 30 standard deviations of the category: less is as good as none, and what is left of
// it once written to a file is rounding.
constexpr double kLeastInformation = 1e-3;

// In the eigenvectors of the information each direction is on its own: the variance 1/l gets sigma^2 more. A
// direction with next to no information has no mean either.
Metric MakeMetric(const ShapeEvidence& evidence, double sigma, Eigen::Index modes) {
  const Eigen::Index all = evidence.information.rows(), rest = all - modes;
  Eigen::MatrixXd information = evidence.information.topLeftCorner(modes, modes);
  Eigen::VectorXd vector = evidence.vector.head(modes);
  if (rest > 0) {  // marginal over the later modes
    Eigen::MatrixXd later = evidence.information.bottomRightCorner(rest, rest);
    later.diagonal().array() += kLeastInformation;
    const Eigen::MatrixXd gain = later.llt().solve(evidence.information.bottomLeftCorner(rest, modes));
    information -= evidence.information.topRightCorner(modes, rest) * gain;
    vector -= gain.transpose() * evidence.vector.tail(rest);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(information);
  const Eigen::ArrayXd l = eigen.eigenvalues().array().max(0);
  const Eigen::ArrayXd weights = l / (1 + sigma * sigma * l);
  const Eigen::ArrayXd along = (eigen.eigenvectors().transpose() * vector).array();
  const Eigen::VectorXd mean = (l > kLeastInformation).select(along / l.max(kLeastInformation), 0).matrix();
  return {weights.sqrt().matrix().asDiagonal() * eigen.eigenvectors().transpose(),
          eigen.eigenvectors() * mean};
}

}  // namespace

Eigen::MatrixXf Features(const CategoryInstances& instances, const Eigen::VectorXd& standard_deviations,
                         const FeatureOptions& options) {
  const Eigen::Index modes = Kept(instances.coefficients.rows(), options), size = options.with_size ? 3 : 0;
  const bool raw = options.space == FeatureSpace::kRaw;
  Eigen::MatrixXf features(modes + size, instances.coefficients.cols());
  features.topRows(modes) = instances.coefficients.topRows(modes);
  if (raw) features.topRows(modes).array().colwise() *= standard_deviations.head(modes).cast<float>().array();
  if (options.with_size)
    features.bottomRows<3>() = instances.sizes / (raw ? 1.0F : static_cast<float>(options.size_sigma));
  return features;
}

Eigen::VectorXf ComputeFeatures(const ShapeQuery& query, const Eigen::VectorXd& standard_deviations,
                                const FeatureOptions& options) {
  CategoryInstances alone;
  alone.coefficients = query.coefficients.cast<float>();
  alone.sizes = query.size.cast<float>();
  return Features(alone, standard_deviations, options);
}

std::vector<Neighbour> Likeliest(const CategoryInstances& instances, const ShapeEvidence& evidence,
                                 double sigma, int modes, int k) {
  const Eigen::Index kept = Kept(instances.coefficients.rows(), {.modes = modes});
  const Metric metric = MakeMetric(evidence, sigma, kept);
  std::vector<Neighbour> neighbours;
  neighbours.reserve(static_cast<size_t>(instances.size()));
  for (Eigen::Index start = 0; start < instances.size(); start += kBlock) {
    const Eigen::Index count = std::min<Eigen::Index>(kBlock, instances.size() - start);
    const Eigen::MatrixXd x = instances.coefficients.block(0, start, kept, count).cast<double>();
    const Eigen::VectorXd distances = (metric.root * (x.colwise() - metric.mean)).colwise().norm();
    for (Eigen::Index i = 0; i < count; ++i)
      neighbours.push_back({static_cast<int>(start + i), distances(i)});
  }
  const auto count = std::min(neighbours.size(), static_cast<size_t>(std::max(k, 0)));
  std::partial_sort(neighbours.begin(), neighbours.begin() + static_cast<std::ptrdiff_t>(count),
                    neighbours.end(), IsNearer);
  neighbours.resize(count);
  return neighbours;
}

}  // namespace armature
