// SPDX-License-Identifier: BSD-3-Clause
// FLANN 1.9's structures over our own distance, with those of its functions replaced that would make no two
// trees alike (Debian's FLANN shuffles with std::random_device, and the rest draws from std::rand). Replacing
// them for our distance alone leaves alone what other libraries do with FLANN.
#pragma once

#include <flann/algorithms/kdtree_index.h>
#include <flann/algorithms/kdtree_single_index.h>
#include <flann/algorithms/kmeans_index.h>
#include <flann/algorithms/linear_index.h>

#include <memory>
#include <numeric>
#include <random>
#include <vector>

namespace armature {

// Squared Euclidean, and where the structures that are built with it take their random numbers from.
struct FeatureDistance : flann::L2<float> {
  std::shared_ptr<std::mt19937_64> random;

  explicit FeatureDistance(std::uint64_t seed = 1) : random(std::make_shared<std::mt19937_64>(seed)) {}

  // Of 0 .. count - 1; the remainder of 64 bits favours small numbers by less than anyone can see.
  size_t Draw(size_t count) const { return (*random)() % count; }

  void Shuffle(std::vector<int>& values) const {
    for (size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[Draw(i)]);
  }
};

inline std::vector<int> UpTo(size_t count) {
  std::vector<int> values(count);
  std::iota(values.begin(), values.end(), 0);
  return values;
}

}  // namespace armature

namespace flann {

// Each tree of a forest divides samples of another order of the points.
template <>
inline void KDTreeIndex<armature::FeatureDistance>::buildIndexImpl() {
  std::vector<int> order = armature::UpTo(size_);
  std::vector<float> mean(veclen_), variance(veclen_);
  mean_ = mean.data();
  var_ = variance.data();
  tree_roots_.resize(static_cast<size_t>(trees_));
  for (NodePtr& root : tree_roots_) {
    distance_.Shuffle(order);
    root = divideTree(order.data(), static_cast<int>(size_));
  }
}

// One of the dimensions of greatest variance.
template <>
inline int KDTreeIndex<armature::FeatureDistance>::selectDivision(float* variance) {
  std::vector<int> dimensions = armature::UpTo(veclen_);
  const size_t top = std::min<size_t>(RAND_DIM, veclen_);
  std::partial_sort(dimensions.begin(), dimensions.begin() + static_cast<std::ptrdiff_t>(top),
                    dimensions.end(), [&](int a, int b) { return variance[a] > variance[b]; });
  return dimensions[distance_.Draw(top)];
}

// The first `wanted` of the shuffled points that are not where another centre is.
template <>
inline void RandomCenterChooser<armature::FeatureDistance>::operator()(int wanted, int* points, int count,
                                                                       int* centers, int& chosen) {
  std::vector<int> order(points, points + count);
  distance_.Shuffle(order);
  chosen = 0;
  for (const int point : order) {
    const bool taken = std::any_of(centers, centers + chosen, [&](int center) {
      return distance_(points_[static_cast<size_t>(point)], points_[static_cast<size_t>(center)], cols_) == 0;
    });
    if (!taken) centers[chosen++] = point;
    if (chosen == wanted) return;
  }
}

}  // namespace flann
