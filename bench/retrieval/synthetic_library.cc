// SPDX-License-Identifier: BSD-3-Clause
#include "bench/retrieval/synthetic_library.h"

#include "geometry/random.h"

namespace armature {
namespace {

constexpr Eigen::Index kDimensions = 7;
constexpr Eigen::Index kFamilies = 300;
constexpr double kBetweenFamilies = 0.9, kWithinFamily = 0.44;  // together a deviation of 1
constexpr double kEstimation = 0.3;

Eigen::VectorXf NormalVector(double deviation, Random& random) {
  return Eigen::VectorXf::NullaryExpr(kDimensions,
                                      [&] { return static_cast<float>(random.Normal(0, deviation)); });
}

Eigen::MatrixXf NormalVectors(Eigen::Index count, double deviation, Random& random) {
  Eigen::MatrixXf vectors(kDimensions, count);
  for (auto vector : vectors.colwise()) vector = NormalVector(deviation, random);
  return vectors;
}

}  // namespace

SyntheticLibrary MakeSyntheticLibrary(Eigen::Index instances, Eigen::Index queries) {
  Random random(1);
  const Eigen::MatrixXf families = NormalVectors(kFamilies, kBetweenFamilies, random);
  SyntheticLibrary library{NormalVectors(instances, kWithinFamily, random),
                           NormalVectors(queries, kEstimation, random)};
  for (auto instance : library.features.colwise()) {
    const double share = random.Uniform(0, 1);
    instance += families.col(static_cast<Eigen::Index>(share * share * kFamilies));
  }
  for (auto query : library.queries.colwise()) {
    const double instance = random.Uniform(0, static_cast<double>(instances));
    query += library.features.col(static_cast<Eigen::Index>(instance));
  }
  return library;
}

}  // namespace armature
