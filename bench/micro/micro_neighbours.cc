// SPDX-License-Identifier: BSD-3-Clause
#include "bench/micro/micro_neighbours.h"

#include <flann/flann.hpp>

#include "datasets/random.h"

namespace armature {
namespace {

constexpr size_t kNeighbours = 5;
constexpr size_t kQueries = 200;

// The tree takes a while and much memory: it is built when the race starts, not when benchmarks are listed.
Contender QueryContender(const std::string& name, size_t points) {
  const auto search = std::make_shared<std::unique_ptr<NeighbourSearch>>();
  const auto found = std::make_shared<std::pair<std::vector<size_t>, std::vector<float>>>(
      std::vector<size_t>(kNeighbours), std::vector<float>(kNeighbours));
  Contender contender = MicroContender(name, kQueries, [search, found, queries = MicroPoints(kQueries, 2)] {
    for (size_t i = 0; i < kQueries; ++i)
      (*search)->Find(&queries[i * NeighbourSearch::kDimensions], found->first, found->second);
  });
  contender.start = [search, points] {
    if (!*search) *search = std::make_unique<NeighbourSearch>(points);
  };
  return contender;
}

}  // namespace

struct NeighbourSearch::Tree {
  flann::Index<flann::L2<float>> index;

  explicit Tree(const flann::Matrix<float>& points) : index(points, flann::KDTreeSingleIndexParams()) {
    index.buildIndex();
  }
};

NeighbourSearch::NeighbourSearch(size_t points)
    : points_(MicroPoints(points, 1)),
      tree_(std::make_unique<Tree>(flann::Matrix<float>(points_.data(), points, kDimensions))) {}

NeighbourSearch::~NeighbourSearch() = default;

void NeighbourSearch::Find(const float* query, std::vector<size_t>& indices,
                           std::vector<float>& squared_distances) {
  // FLANN reads through a pointer to what may be written.
  const flann::Matrix<float> queries(const_cast<float*>(query), 1, kDimensions);
  flann::Matrix<size_t> index_row(indices.data(), 1, indices.size());
  flann::Matrix<float> distance_row(squared_distances.data(), 1, squared_distances.size());
  tree_->index.knnSearch(queries, index_row, distance_row, indices.size(),
                         flann::SearchParams(flann::FLANN_CHECKS_UNLIMITED));
}

std::vector<float> MicroPoints(size_t count, unsigned seed) {
  Random random(seed);
  std::vector<float> points(count * NeighbourSearch::kDimensions);
  for (float& number : points) number = static_cast<float>(random.Uniform(0, 1));
  return points;
}

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
