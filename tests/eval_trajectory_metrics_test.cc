// SPDX-License-Identifier: BSD-3-Clause
// Errors of trajectories and their table.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "eval/trajectories/trajectory_metrics.h"
#include "eval/trajectories/trajectory_tables.h"
#include "geometry/rotation.h"
#include "io/trajectory.h"
#include "support/expect_input_error.h"
#include "support/shared_data.h"

namespace armature {
namespace {

constexpr AlignmentKind kAllKinds[] = {
    AlignmentKind::kNone,  AlignmentKind::kFirstPose, AlignmentKind::kSe3,   AlignmentKind::kSim3,
    AlignmentKind::kScale, AlignmentKind::kEndPoints, AlignmentKind::kFirstN};

TimedPose At(double timestamp, const Eigen::Vector3d& position, const Eigen::Vector3d& rotation = {0, 0, 0}) {
  TimedPose pose{.timestamp = timestamp};
  pose.pose.translation() = position;
  pose.pose.linear() = ExpSO3(rotation);
  return pose;
}

std::vector<TimedPose> Curve(int count) {
  std::vector<TimedPose> poses;
  for (int i = 0; i < count; ++i) {
    const double t = 0.1 * i;
    poses.push_back(At(t, {std::cos(t), 2 * std::sin(t), t * t}, {0.3 * t, std::sin(t), -t}));
  }
  return poses;
}

std::vector<PosePair> Pairs(const std::vector<TimedPose>& estimate, const std::vector<TimedPose>& truth) {
  return PairPoses(estimate, truth, 0.01);
}

TEST(Statistics, OfHandWrittenErrors) {
  const auto s = SummarizeErrors(std::vector<double>{4, 1, 1, 2});
  ASSERT_TRUE(s);
  EXPECT_EQ(s->count, 4u);
  EXPECT_NEAR(s->rmse, std::sqrt(22.0 / 4), 1e-15);
  EXPECT_EQ(s->mean, 2);
  EXPECT_EQ(s->median, 1.5);
  EXPECT_EQ(s->max, 4);
  EXPECT_EQ(s->min, 1);
  EXPECT_NEAR(s->std, std::sqrt(6.0 / 4), 1e-15);
  EXPECT_FALSE(SummarizeErrors(std::vector<double>{}));
}

// UTM coordinates, even Earth-centred ones: where the origins are, is nothing that errors depend on.
TEST(TrajectoryErrors, AreTheSameFarFromTheOrigin) {
  const auto truth = Curve(40);
  auto estimate = Curve(40);
  for (size_t i = 0; i < estimate.size(); ++i) {
    const double a = static_cast<double>(i);
    estimate[i].pose.translation() *= 0.8;
    estimate[i].pose.translation() += 0.02 * Eigen::Vector3d(std::sin(3 * a), std::cos(5 * a), std::sin(a));
    estimate[i].pose = Eigen::Isometry3d(ExpSO3({1, 2, 0.5})) * estimate[i].pose;
  }
  const auto moved = [](std::vector<TimedPose> poses, const Eigen::Vector3d& by) {
    for (TimedPose& pose : poses) pose.pose.translation() += by;
    return poses;
  };
  for (const double distance : {5e5, 5e6}) {
    const Eigen::Vector3d far(distance, -0.4 * distance, 200);
    for (const AlignmentKind kind : kAllKinds) {
      const TrajectoryOptions options{.alignment = kind};
      const auto near = EvaluateTrajectory(estimate, truth, options);
      std::vector<TrajectoryEvaluation> all{
          EvaluateTrajectory(moved(estimate, far), moved(truth, far), options)};
      if (kind != AlignmentKind::kNone) {
        all.push_back(EvaluateTrajectory(estimate, moved(truth, far), options));
        all.push_back(EvaluateTrajectory(moved(estimate, far), truth, options));
      }
      for (const TrajectoryEvaluation& e : all) {
        EXPECT_FALSE(e.alignment.is_degenerate) << AlignmentName(kind);
        EXPECT_NEAR(e.alignment.scale, near.alignment.scale, 1e-6) << AlignmentName(kind);
        EXPECT_NEAR(AbsoluteError(e)->rmse, AbsoluteError(near)->rmse, 1e-6) << AlignmentName(kind);
        EXPECT_NEAR(AbsoluteError(e)->max, AbsoluteError(near)->max, 1e-6) << AlignmentName(kind);
        EXPECT_NEAR(RelativeTranslationError(e)->rmse, RelativeTranslationError(near)->rmse, 1e-6);
        EXPECT_NEAR(RelativeRotationError(e)->rmse, RelativeRotationError(near)->rmse, 1e-6);
      }
    }
  }
}

TEST(AbsoluteError, IsZeroOfTheTruthItself) {
  const auto truth = Curve(40);
  for (const AlignmentKind kind : kAllKinds) {
    const auto e = EvaluateTrajectory(truth, truth, {.alignment = kind});
    EXPECT_EQ(e.poses.size(), 40u);
    EXPECT_LT(AbsoluteError(e)->max, 1e-12);
    EXPECT_LT(RelativeTranslationError(e)->max, 1e-12);
    EXPECT_LT(RelativeRotationError(e)->max, 1e-9);
    for (const PoseError& pose : e.poses) EXPECT_LT(pose.rotation_deg, 1e-9);
  }
}

TEST(AbsoluteError, OfAKnownOffset) {
  auto estimate = Curve(10);
  estimate[3].pose.translation() += Eigen::Vector3d(0.3, 0, -0.4);
  estimate[5].pose.linear() *= ExpSO3({0, 20 * kDegree, 0});
  const auto e = EvaluateTrajectory(estimate, Curve(10), {.alignment = AlignmentKind::kFirstPose});
  EXPECT_NEAR(AbsoluteError(e)->max, 0.5, 1e-12);
  EXPECT_NEAR(AbsoluteError(e)->mean, 0.05, 1e-12);
  EXPECT_NEAR(AbsoluteError(e)->median, 0, 1e-12);
  EXPECT_NEAR(AbsoluteError(e)->rmse, 0.5 / std::sqrt(10), 1e-12);
  EXPECT_NEAR(e.poses[5].rotation_deg, 20, 1e-9);
}

TEST(AbsoluteError, CountsWhatIsMatched) {
  auto estimate = Curve(10);
  estimate.erase(estimate.begin() + 4);
  estimate.push_back(At(7, {0, 0, 0}));
  const auto e = EvaluateTrajectory(estimate, Curve(10), {});
  EXPECT_EQ(e.poses.size(), 9u);
  EXPECT_EQ(e.estimated, 10u);
}

TEST(AbsoluteError, OfNothingIsNothing) {
  for (const AlignmentKind kind : kAllKinds) {
    for (const auto& estimate : {std::vector<TimedPose>{}, std::vector<TimedPose>{At(99, {1, 2, 3})}}) {
      const auto e = EvaluateTrajectory(estimate, Curve(5), {.alignment = kind});
      EXPECT_FALSE(AbsoluteError(e));
      EXPECT_FALSE(RelativeTranslationError(e));
      EXPECT_FALSE(RelativeRotationError(e));
    }
  }
}

TEST(AbsoluteError, OfOnePose) {
  const auto e = EvaluateTrajectory({At(0.2, {5, 5, 5})}, Curve(5), {});
  EXPECT_LT(AbsoluteError(e)->max, 1e-12);
  EXPECT_FALSE(RelativeTranslationError(e));
}

// Each step of the estimate is 0.1 m too long and turns 2 degrees too far.
TEST(RelativeError, OfSteadyDrift) {
  std::vector<TimedPose> truth, estimate;
  for (int i = 0; i < 5; ++i) {
    truth.push_back(At(i, {1.0 * i, 0, 0}));
    estimate.push_back(At(i, {1.1 * i, 0, 0}));
  }
  for (const char* delta : {"1f", "1s", "1m"}) {
    const auto errors = RelativeErrors(Pairs(estimate, truth), 1, RelativeDeltaFromText(delta));
    ASSERT_EQ(errors.size(), 4u) << delta;
    for (const RelativeError& error : errors) EXPECT_NEAR(error.translation, 0.1, 1e-12);
  }
  const auto errors = RelativeErrors(Pairs(estimate, truth), 1, RelativeDeltaFromText("3f"));
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors[1].first, 1u);
  EXPECT_EQ(errors[1].second, 4u);
  EXPECT_NEAR(errors[1].translation, 0.3, 1e-12);
  for (size_t i = 0; i < estimate.size(); ++i) {
    estimate[i] =
        At(estimate[i].timestamp, truth[i].pose.translation(), {0, 2 * kDegree * static_cast<double>(i), 0});
  }
  EXPECT_NEAR(RelativeErrors(Pairs(estimate, truth), 1, RelativeDeltaFromText("2f"))[0].rotation_deg, 4,
              1e-9);
}

TEST(RelativeError, FollowsTheScaleAndNotTheFrame) {
  const auto truth = Curve(30);
  auto estimate = truth;
  for (TimedPose& pose : estimate) {
    pose.pose.translation() /= 4;
    pose.pose = Eigen::Translation3d(1, 2, 3) * Eigen::Isometry3d(ExpSO3({1, 2, 0.5})) * pose.pose;
  }
  const auto sim3 = EvaluateTrajectory(estimate, truth, {.alignment = AlignmentKind::kSim3});
  EXPECT_LT(RelativeTranslationError(sim3)->max, 1e-10);
  const auto se3 = EvaluateTrajectory(estimate, truth, {.alignment = AlignmentKind::kSe3});
  const auto none = EvaluateTrajectory(estimate, truth, {.alignment = AlignmentKind::kNone});
  EXPECT_GT(RelativeTranslationError(se3)->min, 0.5);
  EXPECT_NEAR(RelativeTranslationError(se3)->rmse, RelativeTranslationError(none)->rmse, 1e-12);
}

// Stamps 0, 1, 1.04, 2, 5: from 0 the nearest to 1 s is 1, not 1.04; nothing is 1 s before 5.
TEST(RelativeError, TakesThePoseNearestToDelta) {
  std::vector<TimedPose> poses;
  for (const double t : {0.0, 1.0, 1.04, 2.0, 5.0}) poses.push_back(At(t, {t, 0, 0}));
  const auto errors = RelativeErrors(Pairs(poses, poses), 1, RelativeDeltaFromText("1s"));
  ASSERT_EQ(errors.size(), 3u);
  EXPECT_EQ(errors[0].second, 1u);
  EXPECT_EQ(errors[1].second, 3u);
  EXPECT_EQ(errors[2].first, 2u);
  EXPECT_EQ(errors[2].second, 3u);
  EXPECT_TRUE(RelativeErrors(Pairs(poses, poses), 1, RelativeDeltaFromText("10m")).empty());
}

TEST(RelativeDelta, IsReadWithItsUnit) {
  EXPECT_EQ(RelativeDeltaName(RelativeDeltaFromText("10f")), "10 frames");
  EXPECT_EQ(RelativeDeltaName(RelativeDeltaFromText("0.5m")), "0.5 m");
  EXPECT_EQ(RelativeDeltaFromText("2.5s").value, 2.5);
  for (const std::string bad : {"", "1", "s", "1km", "0s", "-1m", "1.5f", "xs"}) {
    testing::ExpectInputError([&] { RelativeDeltaFromText(bad); }, {"'" + bad + "'", "write one like"});
  }
}

TEST(TrajectoryTable, SaysHowItWasAligned) {
  auto estimate = Curve(20);
  for (TimedPose& pose : estimate) pose.pose.translation() /= 2;
  estimate.push_back(At(50, {0, 0, 0}));
  const TrajectoryOptions options{.alignment = AlignmentKind::kSim3, .delta = {5, DeltaUnit::kFrames}};
  const Table table = TrajectoryTable(
      "desk", {{"a", TrajectoryKind::kTrajectory, EvaluateTrajectory(estimate, Curve(20), options)}}, 3);
  EXPECT_TRUE(FormatTable(table, TableFormat::kCsv)
                  .starts_with("# desk: camera trajectories\n"
                               "run,trajectory,alignment,matched,poses,scale,rotation [deg],translation [m],"
                               "ATE rmse [m],ATE mean [m],ATE median [m],ATE max [m],RPE rmse [m],"
                               "RPE rmse [deg],RPE pairs\n"
                               "a,trajectory,sim3,20,21,2.000,0.000,0.000,"
                               "0.000,0.000,0.000,0.000,0.000,0.000,15\n"));
  const std::string text = FormatTable(table, TableFormat::kText);
  for (const char* told :
       {"within 10 ms", "sim3: moved and scaled", "RPE: error of the motion over 5 frames"}) {
    EXPECT_NE(text.find(told), std::string::npos) << told;
  }
}

TEST(TrajectoryTable, ShowsDashesAndWarnings) {
  const auto unmatched = EvaluateTrajectory({At(50, {1, 2, 3})}, Curve(5), {});
  std::vector<TimedPose> still;
  still.reserve(5);
  for (int i = 0; i < 5; ++i) still.push_back(At(0.1 * i, {1, 2, 3}, {0, 0.1 * i, 0}));
  const auto turning = EvaluateTrajectory(still, still, {.alignment = AlignmentKind::kSim3});
  const std::string text =
      FormatTable(TrajectoryTable("desk",
                                  {{"far", TrajectoryKind::kFile, unmatched, "no pose has a true one"},
                                   {"turn", TrajectoryKind::kFile, turning}},
                                  3),
                  TableFormat::kText);
  EXPECT_NE(text.find("far: no pose has a true one."), std::string::npos) << text;
  EXPECT_NE(text.find("turn: the positions do not determine sim3"), std::string::npos) << text;
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_NE(text.find(" - "), std::string::npos);
}

TEST(TrajectoryTable, RawRowsCarryEveryPose) {
  const auto e = EvaluateTrajectory(Curve(12), Curve(12), {});
  const std::string rows = RawTrajectoryRows("desk", {"a", TrajectoryKind::kTrajectory, e});
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 12);
  EXPECT_TRUE(
      rows.starts_with("a,desk,trajectory,se3,1.000000000000,0.000000,0.000000000,0.000000,1.000000,0.0"))
      << rows;
  EXPECT_TRUE(rows.ends_with(",,,\n"));
  const std::string header = RawTrajectoryHeader();
  EXPECT_EQ(std::count(header.begin(), header.end(), ','),
            std::count(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(rows.find('\n')), ','));
}

// Reference values of another implementation, see the shared data's README.
struct Reference {
  const char *estimate, *truth;
  size_t pairs;
  double se3, sim3, scale;
};

void PrintTo(const Reference& reference, std::ostream* stream) { *stream << reference.estimate; }

class OnRealData : public ::testing::TestWithParam<Reference> {};

TEST_P(OnRealData, AgreesWithTheReference) {
  ARMATURE_SHARED_DATA_OR_SKIP(folder, "trajectories");
  const Reference& reference = GetParam();
  const auto estimate = ReadTumTrajectory(folder / reference.estimate);
  const auto truth = ReadTrajectory(folder / reference.truth, {.repeated = RepeatedStamps::kKept});
  const auto se3 = EvaluateTrajectory(estimate, truth, {.alignment = AlignmentKind::kSe3});
  const auto sim3 = EvaluateTrajectory(estimate, truth, {.alignment = AlignmentKind::kSim3});
  EXPECT_EQ(se3.poses.size(), reference.pairs);
  EXPECT_EQ(se3.alignment.scale, 1);
  EXPECT_NEAR(AbsoluteError(se3)->rmse, reference.se3, 1e-9);
  EXPECT_NEAR(AbsoluteError(sim3)->rmse, reference.sim3, 1e-9);
  EXPECT_NEAR(sim3.alignment.scale, reference.scale, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    Trajectories, OnRealData,
    ::testing::Values(Reference{"freiburg1_xyz-rgbdslam.txt", "freiburg1_xyz-groundtruth.txt", 785,
                                0.013470088849733696, 0.013389384904168208, 1.0080013899313371},
                      Reference{"freiburg1_xyz-ORB_kf_mono.txt", "freiburg1_xyz-groundtruth.txt", 32,
                                0.02430163227762101, 0.009754581898685116, 1.1056223637370342},
                      Reference{"fr2_desk_ORB_kf_mono.txt", "fr2_desk_groundtruth.txt", 118,
                                0.9390492628342705, 0.007729264783424088, 2.2280217535893283}));

}  // namespace
}  // namespace armature
