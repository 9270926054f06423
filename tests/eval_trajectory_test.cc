// SPDX-License-Identifier: BSD-3-Clause
// Pairing and aligning trajectories.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "eval/trajectories/trajectory_alignment.h"
#include "geometry/random.h"
#include "geometry/rotation.h"
#include "support/expect_input_error.h"

namespace armature {
namespace {

constexpr AlignmentKind kAlignments[] = {
    AlignmentKind::kNone,  AlignmentKind::kFirstPose, AlignmentKind::kSe3,   AlignmentKind::kSim3,
    AlignmentKind::kScale, AlignmentKind::kEndPoints, AlignmentKind::kFirstN};

Eigen::Isometry3d Pose(const Eigen::Vector3d& rotation, const Eigen::Vector3d& position) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = ExpSO3(rotation);
  pose.translation() = position;
  return pose;
}

TimedPose At(double timestamp, double x = 0) { return {timestamp, Pose({0, 0, 0}, {x, 0, 0})}; }

// A curve through space with turning cameras.
std::vector<Eigen::Isometry3d> CurvePoses(int count) {
  std::vector<Eigen::Isometry3d> poses;
  for (int i = 0; i < count; ++i) {
    const double a = 0.1 * i;
    poses.push_back(Pose({0.3 * a, std::sin(a), -0.2}, {std::cos(a), 2 * std::sin(a) + 5, 0.3 * a * a}));
  }
  return poses;
}

// The inverse of what an alignment should find.
PosePair Moved(const Eigen::Isometry3d& truth, const Similarity& s, double timestamp) {
  PosePair pair{timestamp, truth, truth};
  pair.estimate.linear() = s.R.transpose() * truth.linear();
  pair.estimate.translation() = s.R.transpose() * (truth.translation() - s.t) / s.scale;
  return pair;
}

std::vector<PosePair> Moved(const std::vector<Eigen::Isometry3d>& truth, const Similarity& s) {
  std::vector<PosePair> pairs;
  pairs.reserve(truth.size());
  for (const Eigen::Isometry3d& pose : truth) {
    pairs.push_back(Moved(pose, s, 0.1 * static_cast<double>(pairs.size())));
  }
  return pairs;
}

Similarity Known(double scale) { return {scale, ExpSO3({2.0, -1.5, 0.7}), {3, -20, 0.5}}; }

void ExpectSame(const Similarity& found, const Similarity& expected, double tolerance = 1e-12) {
  EXPECT_NEAR(found.scale, expected.scale, tolerance);
  EXPECT_LE((found.R - expected.R).norm(), tolerance);
  EXPECT_LE((found.t - expected.t).norm(), 10 * tolerance);
}

void ExpectRotation(const Eigen::Matrix3d& R) {
  EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  EXPECT_GT(R.determinant(), 0);
}

TEST(Alignment, RecoversARigidMotion) {
  const auto pairs = Moved(CurvePoses(30), Known(1));
  for (const AlignmentKind kind : kAlignments) {
    if (kind == AlignmentKind::kNone) continue;
    ExpectSame(Align(pairs, kind, 10), Known(1), 1e-11);
    EXPECT_FALSE(Align(pairs, kind, 10).is_degenerate);
  }
}

TEST(Alignment, RecoversASimilarity) {
  const auto pairs = Moved(CurvePoses(30), Known(2.5));
  for (const auto kind : {AlignmentKind::kSim3, AlignmentKind::kScale, AlignmentKind::kEndPoints}) {
    const Similarity s = Align(pairs, kind, 0);
    ExpectSame(s, Known(2.5), 1e-11);
    EXPECT_LT((s * pairs[7].estimate.translation() - pairs[7].truth.translation()).norm(), 1e-11);
    EXPECT_LT((s.Apply(pairs[7].estimate).matrix() - pairs[7].truth.matrix()).norm(), 1e-11);
  }
  for (const auto kind : {AlignmentKind::kSe3, AlignmentKind::kFirstPose, AlignmentKind::kFirstN}) {
    EXPECT_EQ(Align(pairs, kind, 10).scale, 1);
  }
}

TEST(Alignment, NoneChangesNothing) {
  ExpectSame(Align(Moved(CurvePoses(5), Known(2)), AlignmentKind::kNone, 1), Similarity{}, 0);
}

// The cloud of the estimate is the mirrored one of the truth: the nearest matrix is a reflection.
TEST(Alignment, IsNeverAReflection) {
  auto pairs = Moved(CurvePoses(30), Similarity{});
  for (PosePair& pair : pairs) pair.estimate.translation().x() *= -1;
  ExpectRotation(Align(pairs, AlignmentKind::kSe3, 1).R);
  const Similarity s = Align(pairs, AlignmentKind::kSim3, 1);
  ExpectRotation(s.R);
  EXPECT_GT(s.scale, 0);
  EXPECT_LT(s.scale, 1);
}

// Least squares: no small change of the answer makes the sum smaller.
TEST(Alignment, IsTheMinimum) {
  auto pairs = Moved(CurvePoses(12), Known(0.7));
  for (size_t i = 0; i < pairs.size(); ++i) {
    const double a = static_cast<double>(i);
    pairs[i].estimate.translation() +=
        0.3 * Eigen::Vector3d(std::sin(3 * a), std::cos(5 * a), std::sin(7 * a));
  }
  const auto sum = [&](const Similarity& s) {
    double total = 0;
    for (const PosePair& p : pairs)
      total += (s * p.estimate.translation() - p.truth.translation()).squaredNorm();
    return total;
  };
  for (const auto kind : {AlignmentKind::kSe3, AlignmentKind::kSim3}) {
    const Similarity best = Align(pairs, kind, 1);
    for (int axis = 0; axis < 3; ++axis) {
      for (const double step : {-1e-4, 1e-4}) {
        Similarity turned = best, shifted = best, scaled = best;
        turned.R = ExpSO3(step * Eigen::Vector3d::Unit(axis)) * best.R;
        shifted.t[axis] += step;
        scaled.scale += step;
        EXPECT_GT(sum(turned), sum(best));
        EXPECT_GT(sum(shifted), sum(best));
        if (kind == AlignmentKind::kSim3) {
          EXPECT_GT(sum(scaled), sum(best));
        }
      }
    }
  }
}

TEST(Alignment, FirstNLooksAtNoMore) {
  auto pairs = Moved(CurvePoses(30), Known(1));
  for (size_t i = 10; i < pairs.size(); ++i) pairs[i].estimate.translation() *= 3;
  ExpectSame(Align(pairs, AlignmentKind::kFirstN, 10), Known(1), 1e-11);
  EXPECT_GT((Align(pairs, AlignmentKind::kFirstN, 11).t - Known(1).t).norm(), 0.1);
  ExpectSame(Align(pairs, AlignmentKind::kFirstN, 1000), Align(pairs, AlignmentKind::kSe3, 1), 0);
}

// The scale by hand: estimated end points are 2 apart, the true ones 6; the way between does not count.
TEST(Alignment, EndPointsTakeTheRatioOfDistances) {
  const Eigen::Vector3d none(0, 0, 0);
  std::vector<PosePair> pairs = {{0, Pose(none, {1, 0, 0}), Pose(none, {0, 0, 5})},
                                 {1, Pose(none, {9, 9, 9}), Pose(none, {0, 3, 5})},
                                 {2, Pose(none, {1, 2, 0}), Pose(none, {0, 6, 5})}};
  const Similarity s = Align(pairs, AlignmentKind::kEndPoints, 1);
  EXPECT_EQ(s.scale, 3);
  EXPECT_EQ(s * pairs[2].estimate.translation(), Eigen::Vector3d(0, 6, 5));
  pairs[2].estimate = pairs[0].estimate;
  EXPECT_EQ(Align(pairs, AlignmentKind::kEndPoints, 1).scale, 1);
  EXPECT_TRUE(Align(pairs, AlignmentKind::kEndPoints, 1).is_degenerate);
}

TEST(Alignment, OfNoPairIsTheIdentity) {
  for (const AlignmentKind kind : kAlignments) {
    ExpectSame(Align({}, kind, 1), Similarity{}, 0);
    EXPECT_EQ(Align({}, kind, 1).is_degenerate, kind != AlignmentKind::kNone);
  }
}

TEST(Alignment, OfOnePairPutsThePoseOnTheTrueOne) {
  const auto pairs = Moved(CurvePoses(1), Known(1));
  for (const AlignmentKind kind : kAlignments) {
    if (kind != AlignmentKind::kNone) ExpectSame(Align(pairs, kind, 1), Known(1), 1e-11);
  }
}

// Turning in place: the positions say nothing, the rotations of the cameras say which way the frames are
// turned.
TEST(Alignment, OfTurningInPlaceFollowsTheCameras) {
  std::vector<Eigen::Isometry3d> truth;
  truth.reserve(20);
  for (int i = 0; i < 20; ++i) truth.push_back(Pose({0, 0.3 * i, 0}, {4, 5, 6}));
  const auto pairs = Moved(truth, Known(1));
  for (const AlignmentKind kind : kAlignments) {
    const Similarity s = Align(pairs, kind, 5);
    ASSERT_TRUE(s.R.allFinite() && s.t.allFinite());
    EXPECT_EQ(s.scale, 1);
    if (kind != AlignmentKind::kNone) ExpectSame(s, Known(1), 1e-11);
  }
}

TEST(Alignment, OfStraightMotionFollowsTheCamerasAboutTheLine) {
  std::vector<Eigen::Isometry3d> truth;
  truth.reserve(20);
  for (int i = 0; i < 20; ++i) truth.push_back(Pose({0, 0.1 * i, 0}, Eigen::Vector3d(1, 2, -2) * 0.1 * i));
  const auto pairs = Moved(truth, Known(0.4));
  const Similarity s = Align(pairs, AlignmentKind::kSim3, 1);
  EXPECT_TRUE(s.is_degenerate);
  ExpectSame(s, Known(0.4), 1e-9);
  // Cameras that are mounted the other way round must not turn the line itself.
  auto turned = pairs;
  for (PosePair& pair : turned) pair.estimate.linear() *= Eigen::DiagonalMatrix<double, 3>(-1, 1, -1);
  const Similarity on_line = Align(turned, AlignmentKind::kSe3, 1);
  ExpectRotation(on_line.R);
  const Eigen::Vector3d step = pairs[9].estimate.translation() - pairs[0].estimate.translation();
  EXPECT_GT((on_line.R * step).normalized().dot(Eigen::Vector3d(1, 2, -2) / 3), 1 - 1e-9);
}

// A unit of a micrometre, or of a kilometre: what is small is not still.
TEST(Alignment, KnowsTheScaleOfAnyUnit) {
  for (const double scale : {1e-6, 1e-3, 1e3, 1e6}) {
    const auto pairs = Moved(CurvePoses(30), Known(scale));
    for (const auto kind : {AlignmentKind::kSim3, AlignmentKind::kScale, AlignmentKind::kEndPoints}) {
      const Similarity s = Align(pairs, kind, 0);
      EXPECT_FALSE(s.is_degenerate);
      EXPECT_NEAR(s.scale / scale, 1, 1e-9);
    }
  }
}

TEST(Alignment, KnowsItsNames) {
  for (const AlignmentKind kind : kAlignments) EXPECT_EQ(AlignmentFromName(AlignmentName(kind)), kind);
  EXPECT_EQ(AlignmentFromName("end_points"), AlignmentKind::kEndPoints);
  testing::ExpectInputError([] { AlignmentFromName("sim2"); }, {"'sim2'", "'sim3'"});
}

TEST(Pairing, TakesTheClosestFirst) {
  // 0.004 is nearer to 0.005 than 0 is, so that 0 is left with -0.006.
  const auto pairs = PairPoses({At(0, 1), At(0.004, 2)}, {At(-0.006, 3), At(0.005, 4)}, 0.01);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].timestamp, 0);
  EXPECT_EQ(pairs[0].truth.translation().x(), 3);
  EXPECT_EQ(pairs[1].truth.translation().x(), 4);
}

TEST(Pairing, UsesEveryPoseOnce) {
  const auto pairs = PairPoses({At(0, 1), At(0.002, 2), At(0.004, 3)}, {At(0.002, 4)}, 0.01);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].estimate.translation().x(), 2);
}

TEST(Pairing, BreaksTiesByTheEarliest) {
  auto pairs = PairPoses({At(1, 1), At(1.5, 2)}, {At(1.25, 3)}, 0.5);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].estimate.translation().x(), 1);
  pairs = PairPoses({At(1.25, 1)}, {At(1, 2), At(1.5, 3)}, 0.5);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].truth.translation().x(), 2);
  pairs = PairPoses({At(1.25, 1)}, {At(1.25, 2), At(1.25, 3)}, 0.5);  // a repeated stamp
  EXPECT_EQ(pairs.at(0).truth.translation().x(), 2);
}

// What PairPoses says, pair by pair.
std::vector<std::pair<double, double>> PairGreedily(const std::vector<TimedPose>& estimate,
                                                    const std::vector<TimedPose>& truth, double tolerance) {
  std::vector<bool> estimate_taken(estimate.size()), truth_taken(truth.size());
  std::vector<std::pair<double, double>> pairs;  // the x of both
  for (;;) {
    std::tuple<double, size_t, size_t> best{tolerance + kStampRounding, estimate.size(), truth.size()};
    for (size_t i = 0; i < estimate.size(); ++i) {
      for (size_t j = 0; j < truth.size(); ++j) {
        const double seconds = std::abs(truth[j].timestamp - estimate[i].timestamp);
        if (!estimate_taken[i] && !truth_taken[j]) best = std::min(best, {seconds, i, j});
      }
    }
    const auto [seconds, i, j] = best;
    if (i == estimate.size()) break;
    estimate_taken[i] = truth_taken[j] = true;
    pairs.emplace_back(estimate[i].pose.translation().x(), truth[j].pose.translation().x());
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// Stamps on a grid of quarters: many are repeated, many distances equal.
std::vector<TimedPose> RandomStamps(Random& random, int most) {
  std::vector<TimedPose> poses;
  const int count = static_cast<int>(random.Uniform(0, most));
  double stamp = 0;
  for (int i = 0; i < count; ++i) {
    stamp += 0.25 * std::floor(random.Uniform(0, 4));
    poses.push_back(At(stamp, i));
  }
  return poses;
}

TEST(Pairing, IsTheSameAsTakingOneClosestPairAfterTheOther) {
  Random random(7);
  for (int trial = 0; trial < 2000; ++trial) {
    const auto estimate = RandomStamps(random, 9), truth = RandomStamps(random, 9);
    const double tolerance = std::array{0.0, 0.25, 0.6, 1e9}[static_cast<size_t>(trial % 4)];
    std::vector<std::pair<double, double>> found;
    for (const PosePair& pair : PairPoses(estimate, truth, tolerance))
      found.emplace_back(pair.estimate.translation().x(), pair.truth.translation().x());
    ASSERT_EQ(found, PairGreedily(estimate, truth, tolerance)) << "trial " << trial;
  }
}

// As many candidates as the square of it would not fit the memory.
TEST(Pairing, OfLongTrajectoriesUnderAnyTolerance) {
  std::vector<TimedPose> estimate, truth;
  for (int i = 0; i < 100000; ++i) {
    estimate.push_back(At(i, i));
    truth.push_back(At(i + 0.25, i));
  }
  const auto pairs = PairPoses(estimate, truth, 1e9);
  ASSERT_EQ(pairs.size(), estimate.size());
  for (const PosePair& pair : pairs) ASSERT_EQ(pair.estimate.translation().x(), pair.truth.translation().x());
}

TEST(Pairing, StopsAtTheTolerance) {
  EXPECT_EQ(PairPoses({At(1305031102.16)}, {At(1305031102.17)}, 0.01).size(), 1u);
  EXPECT_TRUE(PairPoses({At(1305031102.16)}, {At(1305031102.1701)}, 0.01).empty());
  EXPECT_TRUE(PairPoses({}, {At(0)}, 0.01).empty());
  EXPECT_TRUE(PairPoses({At(0)}, {}, 0.01).empty());
}

}  // namespace
}  // namespace armature
