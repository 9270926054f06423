// SPDX-License-Identifier: BSD-3-Clause
// What is said of trajectories whose stamps have nothing in common.
#include <gtest/gtest.h>

#include <cmath>

#include "eval/trajectories/unmatched_stamps.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

// Moves and turns unevenly; `rate`: poses a second. Seen from elsewhere and in another unit than the other.
std::vector<TimedPose> UnevenMotion(double rate, double start, bool is_elsewhere) {
  std::vector<TimedPose> poses;
  for (int i = 0; i < 20 * rate; ++i) {
    const double t = i / rate;
    const double way = t + 0.8 * std::sin(0.9 * t) + 0.3 * std::sin(2.3 * t),
                 turn = std::sin(0.4 * t * t / 5);
    TimedPose pose{.timestamp = start + t};
    pose.pose.translation() = Eigen::Vector3d(way, std::cos(way), 0.2 * turn);
    pose.pose.linear() = ExpSO3({0.2 * turn, turn, 0});
    if (is_elsewhere) {
      pose.pose.translation() *= 0.1;
      pose.pose = Eigen::Translation3d(5e5, 3, -7) * Eigen::Isometry3d(ExpSO3({1, -2, 0.3})) * pose.pose;
    }
    poses.push_back(pose);
  }
  return poses;
}

std::vector<TimedPose> Rescaled(std::vector<TimedPose> poses, double factor) {
  for (TimedPose& pose : poses) pose.timestamp *= factor;
  return poses;
}

TEST(UnmatchedStamps, OfTheSameMotionHaveTheOffsetBetweenThem) {
  const auto truth = UnevenMotion(50, 1305031110, true);
  for (const double offset : {100.0, -3600.25, 1305031110.0}) {
    const auto found = FindTimeOffset(UnevenMotion(10, 1305031110 - offset, false), truth);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, offset, 5e-3);
  }
}

TEST(UnmatchedStamps, OfOtherMotionsHaveNoOffset) {
  auto still = UnevenMotion(10, 0, false);
  for (TimedPose& pose : still) pose.pose = Eigen::Isometry3d::Identity();
  const auto truth = UnevenMotion(50, 1000, true);
  EXPECT_FALSE(FindTimeOffset(still, truth));
  EXPECT_FALSE(FindTimeOffset({truth.begin(), truth.begin() + 1}, truth));
}

TEST(UnmatchedStamps, AreExplainedByTheirUnitOrOffset) {
  const auto truth = UnevenMotion(50, 1305031110, true);
  const auto estimate = UnevenMotion(10, 1305031110, false);
  const auto explain = [&](const std::vector<TimedPose>& e, const std::vector<TimedPose>& t) {
    return ExplainUnmatched(e, t, 0.01);
  };
  const auto expect = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos);
  };
  expect(explain(Rescaled(estimate, 1e9), truth), "is the estimate in nanoseconds?");
  expect(explain(Rescaled(estimate, 1e3), truth), "is the estimate in milliseconds?");
  expect(explain(estimate, Rescaled(truth, 1e6)), "is the truth in microseconds?");
  // Counted from 0, where no magnitude tells the unit.
  expect(explain(Rescaled(UnevenMotion(10, 1, false), 1e3), UnevenMotion(50, 1, true)),
         "is the estimate in milliseconds?");
  expect(explain(UnevenMotion(10, 1305031210, false), truth),
         "shifted by 100 s? with --time-offset -100 200 of 200 poses");
  expect(explain(UnevenMotion(10, 1305031210, false), truth), "from 1305031210 to 1305031229.9 s");
  auto still = UnevenMotion(10, 0, false);
  for (TimedPose& pose : still) pose.pose = Eigen::Isometry3d::Identity();
  expect(explain(still, truth), "compare the stamps");
}

}  // namespace
}  // namespace armature
