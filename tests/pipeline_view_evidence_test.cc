// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "pipeline/view_evidence.h"
#include "support/synthetic_view.h"

namespace armature {
namespace {

constexpr ViewEvidence kGood{
    .edges = 8, .cost = 1, .depth_sigma = 0.05, .margin = 4, .hideable_sides = 0.3, .has_viewpoint = true};

// -1.582 + 0.266 * 8 - 1.53 ln 0.05 + 0.397 * 2 + 0.584 * 0.3 = 6.0987
TEST(ViewEvidence, GivesTheProbabilityOfItsOdds) {
  EXPECT_NEAR(ComputeProbability(kGood), 1 / (1 + std::exp(-6.0987)), 1e-6);
}

TEST(ViewEvidence, SpeaksAgainstWhatCostsMuchIsUnsureOrHidden) {
  const auto with = [](auto change) {
    ViewEvidence evidence = kGood;
    change(evidence);
    return ComputeProbability(evidence);
  };
  const double good = ComputeProbability(kGood);
  EXPECT_LT(with([](ViewEvidence& e) { e.cost = 8; }), good);
  EXPECT_LT(with([](ViewEvidence& e) { e.edges = 2; }), good);
  EXPECT_LT(with([](ViewEvidence& e) { e.depth_sigma = 0.2; }), good);
  EXPECT_LT(with([](ViewEvidence& e) { e.margin = 0; }), good);
  EXPECT_LT(with([](ViewEvidence& e) { e.hidden_sides = 1; }), good);
  EXPECT_LT(with([](ViewEvidence& e) { e.has_viewpoint = false; }), good);
}

TEST(ViewEvidence, TellsHiddenSidesFromThoseThatTheImageCuts) {
  testing::SyntheticView synthetic("chair", 0.6, {0.2, 0.4, 2.2}, Eigen::Vector2d::Zero());
  synthetic.view.sides = {BoxSide::kOpen, BoxSide::kSeen, BoxSide::kSeen, BoxSide::kSeen};
  synthetic.view.hidden_probability = {0.7, 0, 0.25, 0.3};
  ObjectEstimate estimate;
  estimate.T_camera_object.translation() << 0, 0, 2;
  estimate.covariance(5, 5) = 0.1 * 0.1;
  const BoxSides taken = {BoxSide::kOpen, BoxSide::kSeen, BoxSide::kSeen, BoxSide::kOpen};
  const ViewEvidence evidence = CollectViewEvidence(synthetic.view, taken, estimate);
  EXPECT_EQ(evidence.hidden_sides, 1);
  EXPECT_NEAR(evidence.hideable_sides, 0.55, 1e-12);
  EXPECT_NEAR(evidence.depth_sigma, 0.05, 1e-12);
}

}  // namespace
}  // namespace armature
