// SPDX-License-Identifier: BSD-3-Clause
// Micro-benchmark of the nearest neighbours of a vector of seven numbers, as descriptors of objects have.
#pragma once

#include <memory>
#include <vector>

#include "bench/micro/micro_benchmark.h"

namespace armature {

// Points uniform in the unit cube of seven dimensions, made by a fixed seed, in one exact k-d tree of FLANN.
class NeighbourSearch {
 public:
  static constexpr size_t kDimensions = 7;

  explicit NeighbourSearch(size_t points);
  ~NeighbourSearch();

  // The nearest points, nearest first; kDimensions numbers are read from `query`.
  void Find(const float* query, std::vector<size_t>& indices, std::vector<float>& squared_distances);

  const std::vector<float>& points() const { return points_; }  // kDimensions numbers each

 private:
  struct Tree;
  std::vector<float> points_;
  std::unique_ptr<Tree> tree_;
};

// Random points, kDimensions numbers each.
std::vector<float> MicroPoints(size_t count, unsigned seed);

// neighbours, one for each number of points.
std::vector<MicroBenchmark> NeighbourBenchmarks(const MicroSetup& setup);

}  // namespace armature
