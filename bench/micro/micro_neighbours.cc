// SPDX-License-Identifier: BSD-3-Clause
#include <optional>

#include "bench/micro/micro_families.h"
#include "geometry/random.h"
#include "retrieval/instance_index.h"

namespace armature {
namespace {

constexpr int kNeighbours = 5;
constexpr size_t kQueries = 200;
constexpr Eigen::Index kDimensions = 7;

// Uniform in the unit cube.
Eigen::VectorXf UniformPoint(Random& random) {
  return Eigen::VectorXf::NullaryExpr(kDimensions, [&] { return static_cast<float>(random.Uniform(0, 1)); });
}

Eigen::MatrixXf UniformPoints(size_t count, unsigned seed) {
  Random random(seed);
  Eigen::MatrixXf points(kDimensions, static_cast<Eigen::Index>(count));
  for (auto point : points.colwise()) point = UniformPoint(random);
  return points;
}

std::vector<Eigen::VectorXf> UniformQueries(unsigned seed) {
  Random random(seed);
  std::vector<Eigen::VectorXf> queries;
  for (size_t i = 0; i < kQueries; ++i) queries.push_back(UniformPoint(random));
  return queries;
}

// The tree takes a while and much memory: it is built when the race starts, not when benchmarks are listed.
Contender QueryContender(const std::string& name, size_t points) {
  const auto index = std::make_shared<std::optional<InstanceIndex>>();
  Contender contender = MicroContender(name, kQueries, [index, queries = UniformQueries(2)] {
    for (const Eigen::VectorXf& query : queries) (*index)->Nearest(query, kNeighbours);
  });
  contender.start = [index, points] {
    if (!*index) index->emplace(UniformPoints(points, 1), IndexMethod{});
  };
  return contender;
}

}  // namespace

std::vector<MicroBenchmark> NeighbourBenchmarks(const MicroSetup& setup) {
  std::vector<MicroBenchmark> benchmarks;
  for (const size_t points : setup.point_sets) {
    const std::string size = std::to_string(points);
    benchmarks.push_back({"neighbours", size,
                          "the 5 nearest of so many vectors of 7 numbers, uniform in a cube, exact (FLANN "
                          "KDTreeSingle); building the tree is not in it",
                          [=] { return QueryContender("neighbours:" + size, points); }});
  }
  return benchmarks;
}

}  // namespace armature
