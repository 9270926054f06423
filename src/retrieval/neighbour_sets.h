// SPDX-License-Identifier: BSD-3-Clause
// What a search of FLANN fills. Its own sets order by distances in single precision and leave to chance which
// of equally near points are kept.
#pragma once

#include <flann/util/result_set.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "retrieval/instance_index.h"

namespace armature {

// Squared, in single precision, so that FLANN, which goes on only below it and adds up with rounding, still
// offers whatever is that far in double precision.
inline float RoundUp(double distance) {
  constexpr double kRounding = 1e-5;
  const double bound = distance * distance * (1 + kRounding) + std::numeric_limits<float>::min();
  return static_cast<float>(std::min<double>(bound, std::numeric_limits<float>::max()));
}

class NeighbourSet : public flann::ResultSet<float> {
 public:
  NeighbourSet(const Eigen::MatrixXf& features, const Eigen::VectorXf& query)
      : features_(features), query_(query.cast<double>()) {}

  std::vector<Neighbour>& found() { return found_; }

 protected:
  Neighbour At(size_t instance) const {
    const auto column = features_.col(static_cast<Eigen::Index>(instance));
    return {static_cast<int>(instance), (column.cast<double>() - query_).norm()};
  }

  std::vector<Neighbour> found_;

 private:
  const Eigen::MatrixXf& features_;
  Eigen::VectorXd query_;
};

// The k nearest, in their order.
class NearestSet : public NeighbourSet {
 public:
  NearestSet(const Eigen::MatrixXf& features, const Eigen::VectorXf& query, size_t k)
      : NeighbourSet(features, query), k_(k) {
    found_.reserve(k + 1);
  }

  bool full() const override { return found_.size() == k_; }
  float worstDist() const override { return bound_; }

  void addPoint(float /*squared_distance*/, size_t instance) override {
    const Neighbour neighbour = At(instance);
    if (full() && !IsNearer(neighbour, found_.back())) return;
    found_.insert(std::upper_bound(found_.begin(), found_.end(), neighbour, IsNearer), neighbour);
    if (found_.size() > k_) found_.pop_back();
    if (full()) bound_ = RoundUp(found_.back().distance);
  }

 private:
  size_t k_;
  float bound_ = std::numeric_limits<float>::max();
};

// All within a radius, in no order.
class WithinSet : public NeighbourSet {
 public:
  WithinSet(const Eigen::MatrixXf& features, const Eigen::VectorXf& query, double radius)
      : NeighbourSet(features, query), radius_(radius) {}

  bool full() const override { return true; }
  float worstDist() const override { return RoundUp(radius_); }

  void addPoint(float /*squared_distance*/, size_t instance) override {
    const Neighbour neighbour = At(instance);
    if (neighbour.distance <= radius_) found_.push_back(neighbour);
  }

 private:
  double radius_;
};

}  // namespace armature
