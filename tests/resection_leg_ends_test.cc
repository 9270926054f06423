// SPDX-License-Identifier: BSD-3-Clause
// Where the segments of legs end is evidence of how far away and how high the object is.
#include <gtest/gtest.h>

#include "resection/line_resection.h"
#include "support/synthetic_view.h"

namespace armature {
namespace {

using testing::SyntheticView;

// Evidence of the front left leg alone, seen as a segment along it that ends `short_by` pixels above its
// foot.
ImageEvidence OneLeg(double leg_end_sigma, double short_by) {
  const SyntheticView chair("chair", 0.5, {0.1, 0.3, 2.5}, Eigen::VectorXd::Zero(1));
  const ProjectedWireframe projected = chair.Project(chair.truth);
  constexpr int kLeg = 7;
  EXPECT_EQ(chair.model.spec.edge_names[kLeg], "leg_front_left");
  Segment segment = projected.edges[kLeg].line;
  segment.p2 -= short_by * projected.edges[kLeg].direction;
  ResectionOptions options;
  options.box_weight = 0;
  options.leg_end_sigma = leg_end_sigma;
  const std::vector<EdgeMatch> matches = {{kLeg, segment, 0}};
  return EvidenceAt({chair.view, {}, matches, projected, chair.truth, {}, options});
}

TEST(LegEnds, AddInformationAlongTheLegAndNoPullAtTheTruth) {
  const ImageEvidence without = OneLeg(0, 0), with = OneLeg(1, 0);
  const Eigen::Vector3d down(0, 1, 0);
  const auto along = [&](const ImageEvidence& e) { return down.dot(e.information.block<3, 3>(3, 3) * down); };
  EXPECT_GT(along(with), 100 * along(without));
  EXPECT_LT(with.gradient.norm(), 1e-6 * with.information.norm());
}

TEST(LegEnds, ALittleShortPullsTheObjectUp) {
  EXPECT_GT(OneLeg(1, 2).gradient(4), 10);  // the cost falls as the object moves along -y, which is up
  EXPECT_LT(std::abs(OneLeg(0, 2).gradient(4)), 1);
}

TEST(LegEnds, FragmentsSayNothing) { EXPECT_LT(std::abs(OneLeg(1, 20).gradient(4)), 1); }

TEST(LegEnds, SegmentsThatGoOnSayNothing) { EXPECT_LT(std::abs(OneLeg(1, -20).gradient(4)), 1); }

}  // namespace
}  // namespace armature
