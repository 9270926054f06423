// SPDX-License-Identifier: BSD-3-Clause
#include "category/dictionary.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/interrupt.h"

namespace armature {
namespace {

constexpr double kSmallestGain = 1e-12;  // relative; smaller improvements are rounding

Eigen::MatrixXd PairwiseDistances(const Eigen::MatrixXd& points) {
  Eigen::MatrixXd distances(points.cols(), points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    distances.col(i) = (points.colwise() - points.col(i)).colwise().norm().transpose();
  }
  return distances;
}

// Distance of each point from its nearest medoid other than `without` (a position in `medoids`, -1: none left
// out).
Eigen::VectorXd NearestDistances(const Eigen::MatrixXd& distances, const std::vector<int>& medoids,
                                 int without) {
  Eigen::VectorXd nearest =
      Eigen::VectorXd::Constant(distances.rows(), std::numeric_limits<double>::infinity());
  for (size_t m = 0; m < medoids.size(); ++m) {
    if (static_cast<int>(m) != without) nearest = nearest.cwiseMin(distances.col(medoids[m]));
  }
  return nearest;
}

struct Candidate {
  int point = -1;
  double cost = std::numeric_limits<double>::infinity();
};

// The point that lowers the cost most when it joins medoids with these nearest distances.
Candidate BestAddition(const Eigen::MatrixXd& distances, const Eigen::VectorXd& nearest) {
  Candidate best;
  for (int i = 0; i < static_cast<int>(distances.cols()); ++i) {
    const double cost = distances.col(i).cwiseMin(nearest).sum();
    if (cost < best.cost) best = {i, cost};
  }
  return best;
}

// Replaces each medoid in turn by the point that lowers the cost most; true if any was replaced.
bool Swap(const Eigen::MatrixXd& distances, MedoidsResult& result) {
  bool changed = false;
  for (size_t m = 0; m < result.medoids.size(); ++m) {
    ThrowIfInterrupted();
    const Candidate best =
        BestAddition(distances, NearestDistances(distances, result.medoids, static_cast<int>(m)));
    if (best.cost >= result.cost * (1 - kSmallestGain)) continue;
    result.medoids[m] = best.point;
    result.cost = best.cost;
    changed = true;
  }
  return changed;
}

std::vector<int> Assign(const Eigen::MatrixXd& distances, const std::vector<int>& medoids) {
  std::vector<int> assignment;
  for (Eigen::Index i = 0; i < distances.cols(); ++i) {
    const auto nearer = [&](int a, int b) { return distances(i, a) < distances(i, b); };
    const auto nearest = std::min_element(medoids.begin(), medoids.end(), nearer);
    assignment.push_back(static_cast<int>(nearest - medoids.begin()));
  }
  return assignment;
}

void SortByMembers(const Eigen::MatrixXd& distances, std::vector<int>& medoids) {
  const std::vector<int> assignment = Assign(distances, medoids);
  std::vector<std::pair<long, int>> ranked;  // minus the number of members, point
  for (size_t m = 0; m < medoids.size(); ++m) {
    ranked.emplace_back(-std::count(assignment.begin(), assignment.end(), static_cast<int>(m)), medoids[m]);
  }
  std::sort(ranked.begin(), ranked.end());
  std::transform(ranked.begin(), ranked.end(), medoids.begin(), [](const auto& r) { return r.second; });
}

}  // namespace

MedoidsResult KMedoids(const Eigen::MatrixXd& points, int k) {
  const Eigen::MatrixXd distances = PairwiseDistances(points);
  const Eigen::Index count = std::min<Eigen::Index>(k, points.cols());
  MedoidsResult result;
  while (static_cast<Eigen::Index>(result.medoids.size()) < count) {  // BUILD
    ThrowIfInterrupted();
    const Candidate best = BestAddition(distances, NearestDistances(distances, result.medoids, -1));
    result.medoids.push_back(best.point);
    result.cost = best.cost;
  }
  while (Swap(distances, result)) {
  }
  SortByMembers(distances, result.medoids);
  result.assignment = Assign(distances, result.medoids);
  return result;
}

}  // namespace armature
