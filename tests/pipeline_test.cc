// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <opencv2/core.hpp>

#include "geometry/rotation.h"
#include "io/options_yaml.h"
#include "pipeline/frame_pipeline.h"
#include "pipeline/object_estimator.h"
#include "pipeline/options.h"
#include "support/expect_input_error.h"
#include "support/synthetic_view.h"
#include "tracking/floor_height.h"
#include "tracking/object_tracks.h"
#include "tracking/up_direction.h"

namespace armature {
namespace {

using testing::SyntheticView;

double AngleDeg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::acos(std::clamp(a.normalized().dot(b.normalized()), -1.0, 1.0)) / kDegree;
}

TEST(ObjectEstimator, FindsPoseAndShapeOfAPerfectView) {
  for (const char* category : {"chair", "table", "laptop"}) {
    SyntheticView synthetic(category, 0.6, {0.2, 0.2, 2.2}, Eigen::Vector2d(0.5, -0.5));
    synthetic.view.detection.azimuth = 0.6 + 12 * kDegree;  // the prior is off
    const SingleViewResult result = EstimateObject(synthetic.view, {}, {});
    EXPECT_EQ(result.estimate.status, EstimateStatus::kOk) << category;
    const Eigen::Isometry3d& T = result.estimate.T_camera_object;
    const double azimuth = ViewpointFromRotation(T.linear(), T.translation()).azimuth;
    const Eigen::Isometry3d& truth = synthetic.truth.T_camera_object;
    const double true_azimuth = ViewpointFromRotation(truth.linear(), truth.translation()).azimuth;
    EXPECT_LT(std::abs(WrapAngle(azimuth - true_azimuth)), 4 * kDegree) << category;
    EXPECT_LT((T.translation() - truth.translation()).norm(), 0.08 * truth.translation().norm()) << category;
    EXPECT_GT(result.times.association_ms, 0);
    EXPECT_GT(result.times.optimization_ms, 0);
  }
}

TEST(ObjectEstimator, ASymmetricTableIsNeverAmbiguousAndAFewLinesOfAChairAre) {
  const SyntheticView table("table", 0.6, {0.2, 0.2, 2.2}, Eigen::Vector2d::Zero());
  EXPECT_FALSE(EstimateObject(table.view, {}, {}).estimate.ambiguous);
  // A laptop's lid is at its rear: all lines seen, it cannot be turned round.
  const SyntheticView laptop("laptop", 0.6, {0.1, 0.2, 1.0}, Eigen::Vector2d::Zero());
  EXPECT_FALSE(EstimateObject(laptop.view, {}, {}).estimate.ambiguous);
  SyntheticView chair("chair", 0.0, {0.0, 0.2, 2.5}, Eigen::Vector2d::Zero());
  chair.view.segments.resize(2);
  EXPECT_TRUE(EstimateObject(chair.view, {}, {}).estimate.ambiguous);
}

TEST(UpEstimator, FindsALookDownWithoutAnyViewpoint) {
  const Camera camera{640, 480, 500, 500, 320, 240, {}};
  const Eigen::Vector3d up = Eigen::Vector3d(0.03, -0.85, -0.5).normalized();
  std::vector<Segment> segments;
  for (int i = 0; i < 14; ++i) {
    const Eigen::Vector3d foot(-1.4 + 0.2 * i, 0.9 - 0.3 * (i % 2), 2.5 + 0.4 * (i % 3));
    segments.push_back({camera.Project(foot), camera.Project(foot + 0.7 * up)});
  }
  UpEstimator estimator;
  EXPECT_LT(AngleDeg(estimator.Predict(camera, segments, {}, std::nullopt).up_camera, up), 1);
}

TEST(ObjectEstimator, NoSegmentsAreTooFewEdges) {
  SyntheticView synthetic("chair", 0.6, {0.2, 0.2, 2.2}, Eigen::Vector2d::Zero());
  synthetic.view.segments.clear();
  EXPECT_EQ(EstimateObject(synthetic.view, {}, {}).estimate.status, EstimateStatus::kTooFewEdges);
}

TEST(ObjectEstimator, ThePrintedVariantRuns) {
  const SyntheticView synthetic("chair", 0.6, {0.2, 0.2, 2.2}, Eigen::Vector2d::Zero());
  AssociationOptions association;
  association.cost = AssociationCost::kPrinted;
  association.hypotheses.printed_translation = true;
  association.refined_hypotheses = 1;
  association.rounds = 1;
  ResectionOptions resection;
  resection.mode = ResectionMode::kAlternating;
  resection.normal_term = NormalTerm::kPrinted;
  const SingleViewResult result = EstimateObject(synthetic.view, association, resection);
  EXPECT_TRUE(result.estimate.T_camera_object.matrix().allFinite());
  EXPECT_EQ(result.estimate.matches.size(),
            synthetic.model.spec.edge_names.size());  // every edge takes a segment
}

double TurnDeg(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle() / kDegree;
}

ObjectEstimate EstimateByPreset(const std::string& preset, const ObjectView& view) {
  Options options;
  const auto presets = std::filesystem::path(ARMATURE_SOURCE_DIR) / "configs/presets";
  ApplyYaml(presets / (preset + ".yaml"), OptionTable(options));
  return EstimateObject(view, options.association, options.resection).estimate;
}

TEST(ObjectEstimator, ThePaperWorksAsMeantAndNotAsPrinted) {
  const SyntheticView synthetic("chair", 0.6, {0.2, 0.2, 2.2}, Eigen::Vector2d::Zero());
  const Eigen::Isometry3d& truth = synthetic.truth.T_camera_object;
  const ObjectEstimate meant = EstimateByPreset("paper_meant", synthetic.view);
  EXPECT_EQ(meant.status, EstimateStatus::kOk);
  EXPECT_EQ(meant.matches.size(), synthetic.model.spec.edge_names.size()) << "every edge takes a segment";
  EXPECT_LT((meant.T_camera_object.translation() - truth.translation()).norm(), 0.3);
  EXPECT_LT(TurnDeg(meant.T_camera_object, truth), 15);
  const ObjectEstimate printed = EstimateByPreset("paper", synthetic.view);
  EXPECT_GT(TurnDeg(printed.T_camera_object, truth), 15);
}

TEST(UpEstimator, VerticalSegmentsCorrectTheVotes) {
  const Camera camera{640, 480, 500, 500, 320, 240, {}};
  const Eigen::Vector3d up = Eigen::Vector3d(0.05, -0.9, -0.4).normalized();
  std::vector<Segment> segments;
  for (int i = 0; i < 12; ++i) {  // posts standing about
    const Eigen::Vector3d foot(-1.2 + 0.2 * i, 0.6, 3 + 0.1 * (i % 3));
    segments.push_back({camera.Project(foot), camera.Project(foot + 0.8 * up)});
    segments.push_back({{20.0 + 45 * i, 30}, {60.0 + 45 * i, 40 + 3.0 * i}});  // clutter
  }
  const UpVote rough{ExpSO3({0.06, 0, 0.05}) * up, 5 * kDegree};
  UpEstimator estimator;
  UpEstimate estimate;
  for (int frame = 0; frame < 5; ++frame) {
    estimate = estimator.Predict(camera, segments, {rough, rough}, Eigen::Isometry3d::Identity());
  }
  EXPECT_GT(AngleDeg(rough.up_camera, up), 4);
  EXPECT_LT(AngleDeg(estimate.up_camera, up), 1);
}

TEST(UpEstimator, ViewpointsThatAllErrAlikeAreCorrectedAndDoNotPullItAwayLater) {
  const Camera camera{640, 480, 500, 500, 320, 240, {}};
  const Eigen::Vector3d up = Eigen::Vector3d(0.05, -0.9, -0.4).normalized();
  std::vector<Segment> posts;
  for (int i = 0; i < 12; ++i) {
    const Eigen::Vector3d foot(-1.2 + 0.2 * i, 0.6, 3 + 0.1 * (i % 3));
    posts.push_back({camera.Project(foot), camera.Project(foot + 0.8 * up)});
  }
  const UpVote biased{ExpSO3({12 * kDegree, 0, 0}) * up, 5 * kDegree};
  UpEstimator estimator;
  UpEstimate estimate;
  for (int frame = 0; frame < 5; ++frame) {
    estimate = estimator.Predict(camera, posts, {biased, biased}, Eigen::Isometry3d::Identity());
  }
  EXPECT_LT(AngleDeg(estimate.up_camera, up), 1);
  for (int frame = 0; frame < 150; ++frame) {  // the posts are no longer seen
    estimate = estimator.Predict(camera, {}, {biased, biased}, Eigen::Isometry3d::Identity());
  }
  EXPECT_LT(AngleDeg(estimate.up_camera, up), 2);
}

TEST(UpEstimator, EarlierFramesCountThroughTheOdometry) {
  const Camera camera{640, 480, 500, 500, 320, 240, {}};
  const Eigen::Vector3d up_odom = Eigen::Vector3d(0, -1, -0.5).normalized();
  UpEstimator estimator;
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  for (int frame = 0; frame < 30; ++frame) {
    T.linear() = ExpSO3({0, 0.03 * frame, 0});
    estimator.Predict(camera, {}, {{T.linear().transpose() * up_odom, 5 * kDegree}}, T);
  }
  T.linear() = ExpSO3({0.4, 1.0, 0});
  const UpEstimate estimate = estimator.Predict(camera, {}, {}, T);  // no vote of its own
  EXPECT_LT(AngleDeg(estimate.up_camera, T.linear().transpose() * up_odom), 3);
}

SingleViewResult MeasuredAs(const PoseAndShape& at) {
  SingleViewResult estimation;
  estimation.estimate.status = EstimateStatus::kOk;
  estimation.estimate.T_camera_object = at.T_camera_object;
  estimation.estimate.coefficients = at.coefficients;
  estimation.measured.estimate = at;
  estimation.measured.covariance =
      Eigen::MatrixXd::Identity(6 + at.coefficients.size(), 6 + at.coefficients.size()) * 1e-4;
  estimation.measured.covariance.bottomRightCorner(at.coefficients.size(), at.coefficients.size()) *= 1e3;
  estimation.measured.shape_prior_information = 0.5;
  return estimation;
}

TEST(FloorHeight, IsLearntFromWhatStandsOnIt) {
  const SyntheticView synthetic("chair", 0.6, {0.2, 0.4, 2.2}, Eigen::Vector2d::Zero());
  const Eigen::Vector3d up = *synthetic.view.up_camera;
  const double truth =
      CameraHeightAbove(WireframeFromCoefficients(synthetic.model, synthetic.truth.coefficients),
                        synthetic.truth.T_camera_object, up);
  FloorHeight floor{FloorOptions{}};
  for (int frame = 0; frame < 60; ++frame) {
    floor.Predict(0.1 * frame, 0.0);
    floor.Update(MeasuredAs(synthetic.truth), synthetic.model, up);
  }
  EXPECT_NEAR(floor.Predict(6.0, 0.0)->camera_height, truth, 0.05);
  EXPECT_NEAR(floor.Predict(6.1, 0.3)->camera_height, truth + 0.3, 0.05);  // the camera rose
}

TEST(FloorHeight, ThatIsKnownIsNotLearnt) {
  const SyntheticView synthetic("chair", 0.6, {0.2, 0.4, 2.2}, Eigen::Vector2d::Zero());
  FloorHeight floor{FloorOptions{}, FloorPrior{2.5, 0.01}};
  for (int frame = 0; frame < 10; ++frame) {
    floor.Predict(0.1 * frame, 0.5);
    floor.Update(MeasuredAs(synthetic.truth), synthetic.model, *synthetic.view.up_camera);
  }
  EXPECT_EQ(floor.Predict(1.0, 0.5)->camera_height, 2.5);
  EXPECT_EQ(floor.Predict(1.0, 0.5)->sigma, 0.01);
}

// A camera that flies past a chair, with an odometry in units of any length.
class ObjectTracksInAnyUnit : public ::testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(MetresAUnit, ObjectTracksInAnyUnit,
                         ::testing::Values(1e-6, 1e-4, 0.01, 0.4, 2.5, 30, 1e3, 1e6),
                         [](const auto& unit) { return std::to_string(unit.index); });

TEST_P(ObjectTracksInAnyUnit, LearnTheScaleAndForeseeTheObject) {
  const SyntheticView synthetic("chair", 0.6, {0.2, 0.4, 2.2}, Eigen::Vector2d::Zero(), 0.0);
  const double scale = GetParam();
  ObjectTracks tracks{TrackOptions{}};
  ObjectView view = synthetic.view;
  const Eigen::Isometry3d T_world_object = synthetic.truth.T_camera_object;  // the first camera is the world
  const auto camera_at = [](int frame) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.translation() << 0.04 * frame, 0, 0.01 * frame;
    return T;
  };
  const auto odometry_of = [&](Eigen::Isometry3d T) {
    T.translation() /= scale;
    return T;
  };
  for (int frame = 0; frame < 50; ++frame) {
    const Eigen::Isometry3d T = camera_at(frame);
    PoseAndShape seen{T.inverse() * T_world_object, synthetic.truth.coefficients};
    view.detection.azimuth =
        ViewpointFromRotation(seen.T_camera_object.linear(), seen.T_camera_object.translation()).azimuth;
    tracks.Follow(0.1 * frame, odometry_of(T));
    tracks.Update(frame == 0 ? kNoTrack : 0, 0.1 * frame, view, MeasuredAs(seen), odometry_of(T));
    tracks.Solve(0.1 * frame);
  }
  EXPECT_TRUE(tracks.Scale().IsKnown());
  EXPECT_NEAR(tracks.Scale().scale, scale, 0.1 * scale);
  const Eigen::Isometry3d T = camera_at(55);
  const auto memory = tracks.Predict(0, odometry_of(T), *view.up_camera);
  ASSERT_TRUE(memory);
  const Eigen::Isometry3d expected = T.inverse() * T_world_object;
  EXPECT_LT((memory->expected.T_camera_object.translation() - expected.translation()).norm(), 0.1);
  EXPECT_LT(AngleDeg(memory->expected.T_camera_object.linear().col(2), expected.linear().col(2)), 3);
}

TEST(ObjectTracks, ADetectionWhereTheObjectIsExpectedContinuesItsTrack) {
  const SyntheticView synthetic("chair", 0.6, {0.2, 0.4, 2.2}, Eigen::Vector2d::Zero());
  ObjectTracks tracks{TrackOptions{}};
  tracks.Update(kNoTrack, 0, synthetic.view, MeasuredAs(synthetic.truth), Eigen::Isometry3d::Identity());
  tracks.Solve(0);
  ObjectView elsewhere = synthetic.view;
  elsewhere.detection.box.x += 300;
  EXPECT_EQ(tracks.Associate(0.1, {elsewhere, synthetic.view}, Eigen::Isometry3d::Identity()),
            (std::vector<int>{-1, 0}));
}

TEST(ObjectTracks, PriorsTurnedByHalfATurnAreOutvoted) {
  const SyntheticView synthetic("chair", 0.6, {0.2, 0.4, 2.2}, Eigen::Vector2d::Zero());
  ObjectTracks tracks{TrackOptions{}};
  ObjectView view = synthetic.view;
  for (int frame = 0; frame < 10; ++frame) {
    view.detection.azimuth = 0.6 + (frame == 4 ? M_PI : 0.0);
    tracks.Update(frame == 0 ? kNoTrack : 0, 0.1 * frame, view, MeasuredAs(synthetic.truth),
                  Eigen::Isometry3d::Identity());
    tracks.Solve(0.1 * frame);
  }
  const auto memory = tracks.Predict(0, Eigen::Isometry3d::Identity(), *view.up_camera);
  ASSERT_TRUE(memory);
  const Eigen::Vector3d front = synthetic.truth.T_camera_object.linear().col(2);
  const double yaw = std::atan2(front.dot(memory->yaw_quarter), front.dot(memory->yaw_zero));
  EXPECT_LT(memory->belief.At(yaw), 1);
  EXPECT_GT(memory->belief.At(yaw + M_PI), 3);
}

TEST(FramePipeline, ADetectionGivenThriceIsSeenOnce) {
  const SyntheticView synthetic("chair", 0.6, {0.2, 0.4, 2.2}, Eigen::Vector2d::Zero());
  FramePipeline pipeline(Options{}, synthetic.camera, {synthetic.model}, std::nullopt);
  std::vector<Detection> thrice(3, synthetic.view.detection);
  thrice[0].score = 0.5;
  thrice[1].score = 0.9;
  thrice[2].score = 0.4;
  thrice[2].box.x += 4;
  Detection beside = synthetic.view.detection;
  beside.box.x += 0.3 * beside.box.width;
  thrice.push_back(beside);
  const FrameResult frame =
      pipeline.Process(cv::Mat::zeros(480, 856, CV_8U), {0.0, thrice, Eigen::Isometry3d::Identity()});
  ASSERT_EQ(frame.observations.size(), 4u);
  EXPECT_EQ(frame.observations[0].estimate.status, EstimateStatus::kRepeated);
  EXPECT_NE(frame.observations[1].estimate.status, EstimateStatus::kRepeated);
  EXPECT_EQ(frame.observations[2].estimate.status, EstimateStatus::kRepeated);
  EXPECT_NE(frame.observations[3].estimate.status, EstimateStatus::kRepeated);
}

// The world is the odometry's frame in metres, wherever its origin is.
TEST(FramePipeline, TheFirstCameraStandsWhereTheOdometryHasIt) {
  const SyntheticView synthetic("chair", 0.6, {0.2, 0.4, 2.2}, Eigen::Vector2d::Zero());
  FramePipeline pipeline(Options{}, synthetic.camera, {synthetic.model}, std::nullopt, true);
  const cv::Mat black = cv::Mat::zeros(480, 856, CV_8U);
  const Eigen::Vector3d start(5e5, 5.4e6, 120);
  for (int frame = 0; frame < 3; ++frame) {
    const Eigen::Vector3d position = start + Eigen::Vector3d(0.1 * frame, 0, 0);
    pipeline.Process(black, {0.1 * frame, {}, Eigen::Isometry3d(Eigen::Translation3d(position))});
  }
  const auto maps = pipeline.SolveMaps();
  ASSERT_TRUE(maps);
  EXPECT_LT((maps->map.T_world_camera[0].translation() - start).norm(), 1e-6);
  EXPECT_NEAR(maps->map.T_world_camera[2].translation().x(), start.x() + 0.2, 1e-6);
}

TEST(FramePipeline, AFrameWithoutDetectionsHasNoObservations) {
  const SyntheticView synthetic("chair", 0.6, {0.2, 0.4, 2.2}, Eigen::Vector2d::Zero());
  FramePipeline pipeline(Options{}, synthetic.camera, {synthetic.model}, std::nullopt);
  const FrameResult result = pipeline.Process(cv::Mat::zeros(480, 856, CV_8U), {0.0, {}, std::nullopt});
  EXPECT_TRUE(result.observations.empty());
  EXPECT_TRUE(result.segments.empty());
  EXPECT_NEAR(result.up_camera.norm(), 1, 1e-9);
}

TEST(FramePipeline, ADetectionOfACategoryWithoutModelIsAnError) {
  const SyntheticView synthetic("chair", 0.6, {0.1, 0.2, 2.8}, Eigen::Vector2d::Zero());
  FramePipeline pipeline(Options{}, synthetic.camera, {synthetic.model}, std::nullopt);
  Detection sofa = synthetic.view.detection;
  sofa.category = "sofa";
  const cv::Mat black = cv::Mat::zeros(480, 856, CV_8U);
  testing::ExpectInputError([&] { pipeline.Process(black, {0.0, {sofa}, std::nullopt}); }, {"'sofa'"});
}

TEST(FramePipeline, WithoutOdometryThereIsNoMap) {
  const SyntheticView synthetic("chair", 0.6, {0.2, 0.4, 2.2}, Eigen::Vector2d::Zero());
  FramePipeline pipeline(Options{}, synthetic.camera, {synthetic.model}, std::nullopt);
  const cv::Mat black = cv::Mat::zeros(480, 856, CV_8U);
  pipeline.Process(black, {0.0, {synthetic.view.detection}, std::nullopt});
  EXPECT_FALSE(pipeline.SolveMaps());
  EXPECT_TRUE(pipeline.CurrentMap().T_world_camera.empty());
}

// Nothing to see: the map is the odometry's way, in the unit it is expected to have.
TEST(FramePipeline, WithOdometryEveryFrameIsInTheMap) {
  const SyntheticView synthetic("chair", 0.6, {0.2, 0.4, 2.2}, Eigen::Vector2d::Zero());
  FramePipeline pipeline(Options{}, synthetic.camera, {synthetic.model}, std::nullopt);
  const cv::Mat black = cv::Mat::zeros(480, 856, CV_8U);
  for (int frame = 0; frame < 3; ++frame) {
    const Eigen::Isometry3d T(Eigen::Translation3d(0.1 * frame, 0, 0));
    pipeline.Process(black, {0.1 * frame, {}, T});
    EXPECT_EQ(pipeline.CurrentMap().T_world_camera.size(), static_cast<size_t>(frame + 1));
  }
  const auto maps = pipeline.SolveMaps();
  ASSERT_TRUE(maps);
  ASSERT_EQ(maps->map.T_world_camera.size(), 3u);
  EXPECT_TRUE(maps->map.objects.empty());
  EXPECT_NEAR(maps->map.T_world_camera[2].translation().x(), 0.2 * pipeline.OdometryScale().scale, 1e-6);
}

TEST(FramePipeline, IdenticalInputGivesIdenticalOutput) {
  const SyntheticView synthetic("chair", 0.6, {0.2, 0.4, 2.2}, Eigen::Vector2d::Zero());
  cv::Mat image(480, 856, CV_8U);
  cv::RNG rng(7);
  rng.fill(image, cv::RNG::UNIFORM, 0, 255);
  const auto run = [&] {
    FramePipeline pipeline(Options{}, synthetic.camera, {synthetic.model}, std::nullopt);
    return pipeline.Process(image, {0.0, {synthetic.view.detection}, Eigen::Isometry3d::Identity()});
  };
  const FrameResult a = run(), b = run();
  EXPECT_EQ(a.observations[0].estimate.T_camera_object.matrix(),
            b.observations[0].estimate.T_camera_object.matrix());
  EXPECT_EQ(a.observations[0].estimate.cost, b.observations[0].estimate.cost);
}

}  // namespace
}  // namespace armature
