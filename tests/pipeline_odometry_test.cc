// SPDX-License-Identifier: BSD-3-Clause
// The odometry before it is used: its unit, and what it tells that the camera did not do.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tracking/odometry_jumps.h"
#include "tracking/odometry_unit.h"

namespace armature {
namespace {

Eigen::Isometry3d At(double x, double yaw = 0) {
  Eigen::Isometry3d pose(Eigen::Translation3d(x, 0, 0));
  pose.rotate(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitY()));
  return pose;
}

TEST(OdometryUnit, IsTheMetreOfAMetricOdometryFromTheStart) {
  OdometryUnit unit(true);
  unit.Follow(0, At(0));
  unit.Follow(0.1, At(70));
  unit.Learn(1, 1, 0.01);
  unit.Update();
  EXPECT_EQ(unit.Scale().scale, 1);
  EXPECT_EQ(unit.Scale().sigma, 0);
}

TEST(OdometryUnit, IsGuessedByTheSpeedAndThenLearnt) {
  for (const double units : {1e-5, 1.0, 1e5}) {
    OdometryUnit unit(false);
    unit.Follow(0, At(3 * units));
    EXPECT_FALSE(unit.Scale().IsKnown());
    for (int frame = 1; frame < 20; ++frame) unit.Follow(0.1 * frame, At((3 + 0.05 * frame) * units));
    EXPECT_GT(unit.units_a_metre(), units);  // rather too slow than too fast
    EXPECT_LT(unit.units_a_metre(), 20 * units);
    for (int view = 0; view < 60; ++view) {
      unit.Learn(unit.log_units() - std::log(units), 1, 0.05);
      unit.Update();
    }
    EXPECT_TRUE(unit.Scale().IsKnown());
    EXPECT_NEAR(unit.units_a_metre() / units, 1, 0.02);
  }
}

// Trembling on the spot is no way: its steps do not add up.
TEST(OdometryUnit, TremblingCountsForLittle) {
  OdometryUnit walking(false), trembling(false);
  for (int frame = 0; frame < 100; ++frame) {
    walking.Follow(0.1 * frame, At(0.02 * frame));
    trembling.Follow(0.1 * frame, At(frame % 2 == 0 ? 0 : 0.02));
  }
  EXPECT_LT(trembling.units_a_metre(), 0.2 * walking.units_a_metre());
}

// Objects that are seen where the true camera would see them; how well, falls with the distance from it.
class Way {
 public:
  Way(double reach, bool has_objects = true) : reach_(reach), has_objects_(has_objects) {}

  OdometryJumps::Step Go(double seconds, double true_x, double told_x, double told_yaw = 0) {
    time_ += seconds;
    const auto agreement = [&](const Eigen::Isometry3d& camera) -> std::optional<double> {
      if (!has_objects_) return std::nullopt;
      return std::exp(-std::abs(camera.translation().x() - true_x) / reach_);
    };
    return jumps_.Follow(time_, At(told_x, told_yaw), true, agreement);
  }

 private:
  OdometryJumps jumps_;
  double reach_ = 1, time_ = 0;
  bool has_objects_ = true;
};

TEST(OdometryJumps, AnEvenWayHasNone) {
  Way way(0.3);
  for (int frame = 0; frame < 60; ++frame) {
    const auto step = way.Go(0.1, 0.05 * frame, 0.05 * frame);
    EXPECT_FALSE(step.is_jump) << frame;
    EXPECT_FALSE(step.unit_change) << frame;
    EXPECT_EQ(step.T_odom_camera.matrix(), At(0.05 * frame).matrix());
  }
}

TEST(OdometryJumps, AreTakenOutAndTheWayGoesOn) {
  for (const bool has_objects : {true, false}) {
    Way way(0.3, has_objects);
    for (int frame = 0; frame < 40; ++frame) {
      const double x = 0.05 * frame;
      const auto step = way.Go(0.1, x, frame < 20 ? x : x + 1.5);
      EXPECT_EQ(step.is_jump, frame == 20) << frame;
      EXPECT_NEAR(step.T_odom_camera.translation().x(), x, 1e-9) << frame;
    }
  }
}

TEST(OdometryJumps, ATurnThatCannotBeIsOne) {
  Way way(0.3, false);
  for (int frame = 0; frame < 40; ++frame) {
    const auto step = way.Go(0.1, 0, 0.05 * frame, frame < 20 ? 0 : 1.5);
    EXPECT_EQ(step.is_jump, frame == 20) << frame;
  }
}

// The camera did leap, on a robot that was pushed: the objects are seen where it says.
TEST(OdometryJumps, AStepThatTheObjectsAreForIsBelieved) {
  Way way(0.3);
  for (int frame = 0; frame < 40; ++frame) {
    const double x = 0.05 * frame + (frame < 20 ? 0 : 1.5);
    const auto step = way.Go(0.1, x, x);
    EXPECT_FALSE(step.is_jump) << frame;
    EXPECT_EQ(step.T_odom_camera.translation().x(), x);
  }
}

// The camera goes faster at once, and one frame's detections are such as if it did not.
TEST(OdometryJumps, OneFrameAgainstItIsNoChangeOfUnit) {
  Way way(0.2);
  for (int frame = 0; frame < 60; ++frame) {
    const double as_before = 0.1 * frame, x = frame <= 20 ? as_before : 2 + 2 * (as_before - 2);
    EXPECT_FALSE(way.Go(0.2, frame == 25 ? as_before : x, x).unit_change) << frame;
  }
}

TEST(OdometryJumps, AChangeOfUnitIsUndone) {
  for (const double factor : {0.5, 2.0}) {
    Way way(0.2);
    int found = 0;
    for (int frame = 0; frame < 60; ++frame) {
      const double x = 0.1 * frame;
      const auto step = way.Go(0.2, x, frame <= 20 ? x : 2 + factor * (x - 2));
      if (!step.unit_change) continue;
      ++found;
      EXPECT_NEAR(step.unit_change->factor, factor, 0.05 * factor);
      EXPECT_NEAR(step.unit_change->from.x(), 2, 1e-9);
      EXPECT_NEAR(step.unit_change->timestamp, 0.2 * 21, 1e-9);
    }
    EXPECT_EQ(found, 1);
    EXPECT_NEAR(way.Go(0.2, 6, 2 + factor * 4).T_odom_camera.translation().x(), 6, 0.3);
  }
}

// A camera that walks faster: the objects are seen where it says.
TEST(OdometryJumps, AChangeOfSpeedIsBelieved) {
  Way way(0.2);
  double x = 0;
  for (int frame = 0; frame < 60; ++frame) {
    x += frame <= 20 ? 0.1 : 0.2;
    const auto step = way.Go(0.2, x, x);
    EXPECT_FALSE(step.unit_change) << frame;
    EXPECT_NEAR(step.T_odom_camera.translation().x(), x, 1e-12);
  }
}

}  // namespace
}  // namespace armature
