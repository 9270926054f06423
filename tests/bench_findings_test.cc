// SPDX-License-Identifier: BSD-3-Clause
// What was found in a frame against the truth.
#include <gtest/gtest.h>

#include "bench/sections/findings.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

FrameTruth ChairAhead() {
  TrueDetection chair;
  chair.category = "chair";
  chair.T_camera_object.translation() << 0, 0, 2;
  chair.edges = {EdgeSeenInPart({{10, 10}, {110, 10}}, 1, 100)};
  return {chair, std::nullopt};
}

ObjectEstimate EstimateAt(double depth, double turn_deg) {
  ObjectEstimate estimate;
  estimate.status = EstimateStatus::kOk;
  estimate.T_camera_object.translation() << 0, 0, depth;
  estimate.T_camera_object.linear() = ExpSO3({0, turn_deg * kDegree, 0});
  return estimate;
}

TEST(Findings, AreComparedWithTheTruthOfTrueObjectsOnly) {
  Findings findings;
  const std::vector<Segment> half{{{10, 11}, {60, 11}}};
  AddFindings(ChairAhead(), half, {EstimateAt(2.2, 20), EstimateAt(9, 90)}, findings);
  AddFindings(ChairAhead(), {}, {ObjectEstimate{}, EstimateAt(9, 90)}, findings);  // without pose
  EXPECT_EQ(findings.detections, 2);
  const auto accuracy = ComputeAccuracy(findings);
  ASSERT_TRUE(accuracy);
  EXPECT_NEAR(accuracy->azimuth_deg, 20, 1e-6);
  EXPECT_NEAR(accuracy->translation_percent, 10, 1e-6);
  EXPECT_EQ(accuracy->with_pose, 0.5);
  EXPECT_EQ(accuracy->within_15_deg, 0);
  const EdgeRecall recall = AllRecall(findings);
  EXPECT_NEAR(recall.covered / recall.visible, 0.25, 0.02);  // half of the edge in one of two frames
}

TEST(Findings, AsAccurateMeansInEachNumber) {
  const Accuracy reference{2, 4, 0.9, 1};
  EXPECT_TRUE(IsAsAccurate({2.1, 4.3, 0.82, 0.95}, reference, 0.1));
  EXPECT_FALSE(IsAsAccurate({2.3, 1, 1, 1}, reference, 0.1));
  EXPECT_FALSE(IsAsAccurate({1, 4.5, 1, 1}, reference, 0.1));
  EXPECT_FALSE(IsAsAccurate({1, 1, 0.8, 1}, reference, 0.1));
  EXPECT_FALSE(IsAsAccurate({1, 1, 1, 0.85}, reference, 0.1));
  EXPECT_FALSE(ComputeAccuracy(Findings{}));
}

}  // namespace
}  // namespace armature
