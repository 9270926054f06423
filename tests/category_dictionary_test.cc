// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "category/dictionary.h"

namespace armature {
namespace {

// Clusters of 3, 5 and 4 points around (0,0), (10,0) and (0,10); the first of each is its centre.
Eigen::MatrixXd ThreeClusters() {
  Eigen::MatrixXd points(2, 12);
  points << 0, 1, -1, 10, 11, 9, 10, 10, 0, 1, -1, 0,  //
      0, 0, 0, 0, 0, 0, 1, -1, 10, 10, 10, 11;
  return points;
}

TEST(KMedoids, FindsTheCentresOfObviousClustersLargestFirst) {
  const MedoidsResult result = KMedoids(ThreeClusters(), 3);
  EXPECT_EQ(result.medoids, (std::vector<int>{3, 8, 0}));
  EXPECT_EQ(result.assignment, (std::vector<int>{2, 2, 2, 0, 0, 0, 0, 0, 1, 1, 1, 1}));
  EXPECT_DOUBLE_EQ(result.cost, 2 + 4 + 3);
}

TEST(KMedoids, OneMedoidIsTheMostCentralPoint) {
  const Eigen::MatrixXd points = (Eigen::MatrixXd(1, 5) << 0, 1, 2, 3, 100).finished();
  EXPECT_EQ(KMedoids(points, 1).medoids, std::vector<int>{2});
}

TEST(KMedoids, SwapLeavesWhatBuildChoseBadly) {
  // BUILD starts in the middle (point 2); the best pair are the two pairs' members.
  const Eigen::MatrixXd points = (Eigen::MatrixXd(1, 5) << -10, -9.9, 0, 9.9, 10).finished();
  const MedoidsResult result = KMedoids(points, 3);
  EXPECT_NEAR(result.cost, 0.2, 1e-12);
}

TEST(KMedoids, NeverMoreMedoidsThanPoints) {
  EXPECT_EQ(KMedoids(ThreeClusters().leftCols(2), 4).medoids.size(), 2u);
}

}  // namespace
}  // namespace armature
