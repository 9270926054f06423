// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>

#include "bench/harness.h"
#include "bench/keypoints/keypoint_input.h"
#include "bench/keypoints/keypoint_resection.h"
#include "bench/keypoints/keypoints_engine.h"
#include "support/synthetic_view.h"

namespace armature {
namespace {

using testing::SyntheticView;

// Frames with one chair, with the same chair without a viewpoint and a second one, and without any.
class KeypointsEngine : public ::testing::Test {
 protected:
  KeypointsEngine() {
    const cv::Mat gray(480, 856, CV_8U, cv::Scalar(90));
    sequence_.camera = chair_.camera;
    sequence_.up_odom = chair_.view.up_camera;
    sequence_.frames.resize(3, {gray, {}});
    Detection without_viewpoint = chair_.view.detection;
    without_viewpoint.azimuth.reset();
    sequence_.frames[0].input.detections = {chair_.view.detection};
    sequence_.frames[1].input.detections = {without_viewpoint, chair_.view.detection};
    for (BenchFrame& frame : sequence_.frames) frame.input.T_odom_camera = Eigen::Isometry3d::Identity();
  }

  std::unique_ptr<Engine> Make(KeypointsMode mode) const {
    return MakeKeypointsEngine(mode, Options{}, {chair_.model});
  }

  std::vector<FrameOutcome> Run(Engine& engine) const {
    EXPECT_TRUE(engine.IsStateless());
    engine.Start(sequence_);
    std::vector<FrameOutcome> outcomes;
    for (const BenchFrame& frame : sequence_.frames) outcomes.push_back(engine.Process(frame));
    return outcomes;
  }

  const SyntheticView chair_{"chair", 0.5, {0.2, 0.3, 2.5}, Eigen::Vector3d::Zero()};
  BenchSequence sequence_;
};

void ExpectStages(const FrameOutcome& outcome, int objects, double least_detection_ms) {
  EXPECT_EQ(outcome.objects, objects);
  ASSERT_TRUE(outcome.stage(BenchStage::kDetection) && outcome.stage(BenchStage::kAssociation) &&
              outcome.stage(BenchStage::kOptimization));
  EXPECT_GE(*outcome.stage(BenchStage::kDetection), least_detection_ms);
  EXPECT_FALSE(outcome.stage(BenchStage::kMapping));
  EXPECT_TRUE(outcome.estimates.empty());
  EXPECT_EQ(outcome.segments, 0);
  const bool worked =
      *outcome.stage(BenchStage::kAssociation) > 0 && *outcome.stage(BenchStage::kOptimization) > 0;
  EXPECT_EQ(worked, objects > 0);
}

void ExpectSays(const Engine& engine, const std::string& part) {
  EXPECT_NE(engine.Description().find(part), std::string::npos) << engine.Description();
}

TEST_F(KeypointsEngine, PublishedTimeIsAddedForEveryObject) {
  const auto engine = Make(KeypointsMode::kPublished);
  ExpectSays(*engine, "285 ms an object on a Titan X, added and not waited for");
  const std::vector<FrameOutcome> outcomes = Run(*engine);
  for (size_t i = 0; i < 3; ++i) {
    const int objects = std::array{1, 2, 0}[i];
    ExpectStages(outcomes[i], objects, 285.0 * objects);
    EXPECT_DOUBLE_EQ(outcomes[i].added_ms, 285.0 * objects);
  }
}

TEST_F(KeypointsEngine, WaitingTakesThePublishedTime) {
  const auto engine = Make(KeypointsMode::kWait);
  ExpectSays(*engine, "a wait of the paper's 285 ms");
  sequence_.frames.resize(1);
  const FrameOutcome outcome = Run(*engine).front();
  ExpectStages(outcome, 1, 0.95 * 285);
  EXPECT_EQ(outcome.added_ms, 0);
}

TEST_F(KeypointsEngine, TheHourglassIsRunAndNothingIsAdded) {
  const auto engine = Make(KeypointsMode::kHourglass);
  ExpectSays(*engine, "6.73 M parameters, 8.97 G multiply-adds");
  sequence_.frames.resize(1);
  const FrameOutcome outcome = Run(*engine).front();
  ExpectStages(outcome, 1, 1e-3);
  EXPECT_EQ(outcome.added_ms, 0);
}

TEST_F(KeypointsEngine, TakesPartInARace) {
  const auto engine = Make(KeypointsMode::kPublished);
  const std::vector<BenchRow> rows = RunInterleaved(
      {MakeContender("keypoints:published", *engine, sequence_)}, 3, {.warm_up = 1, .repetitions = 2});
  ASSERT_EQ(rows.size(), 4u);
  for (const BenchRow& row : rows) {
    EXPECT_DOUBLE_EQ(row.outcome.added_ms, row.input == 1 ? 570 : 0);
    EXPECT_GE(row.total_ms() + 1e-9, *row.outcome.stage(BenchStage::kDetection));
  }
}

TEST(DrawnKeypoints, AreTheMeanShapesButForNoiseAndATurn) {
  const SyntheticView synthetic("table", 0.5, {0.1, 0.2, 3}, Eigen::Vector3d::Zero());
  const std::vector<ShapePoint> keypoints = MakeKeypoints(synthetic.model);
  const Eigen::Matrix3Xd points = KeypointsAt(keypoints, PoseFromBox(synthetic.view));
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed), same(seed);
    const std::vector<Eigen::Vector2d> drawn = DrawnKeypoints(synthetic.view, keypoints, random);
    EXPECT_EQ(drawn, DrawnKeypoints(synthetic.view, keypoints, same));
    for (size_t i = 0; i < drawn.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      sum += (drawn[i] - synthetic.camera.Project(points.col(column))).norm() / 20;
    }
  }
  const double mean = sum / static_cast<double>(keypoints.size());
  EXPECT_GT(mean, 2);
  EXPECT_LT(mean, 40);
}

TEST(DrawnKeypoints, DistortionIsTheInverseOfUndistortion) {
  const Camera camera{640, 480, 500, 510, 320, 240, {-0.2, 0.05, 0.001, -0.002, 0}};
  const Eigen::Vector2d pixel(500, 100);
  EXPECT_GT((DistortPixel(camera, pixel) - pixel).norm(), 1);
  EXPECT_LT((UndistortPixel(camera, DistortPixel(camera, pixel)) - pixel).norm(), 1e-4);
}

}  // namespace
}  // namespace armature
