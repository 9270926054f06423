// SPDX-License-Identifier: BSD-3-Clause
// How an object is turned and tilted against the true one.
#include <gtest/gtest.h>

#include "geometry/rotation.h"
#include "truth/orientation_error.h"

namespace armature {
namespace {

const Eigen::Matrix3d kTrue = ExpSO3({0.4, -1.2, 2.1});

Eigen::Matrix3d Turn(double degrees) { return ExpSO3(degrees * kDegree * Eigen::Vector3d::UnitY()); }
Eigen::Matrix3d Tilt(double pitch, double roll) { return ExpSO3(kDegree * Eigen::Vector3d(pitch, 0, roll)); }

TEST(Orientation, TheTruthItself) {
  const OrientationError error = CompareOrientation(kTrue, kTrue, 1);
  EXPECT_NEAR(error.azimuth_deg, 0, 1e-9);
  EXPECT_NEAR(error.tilt_deg, 0, 1e-9);
}

TEST(Orientation, TurnsAndTiltsAreTakenApart) {
  const OrientationError error = CompareOrientation(kTrue * Turn(-70) * Tilt(5, -12), kTrue, 1);
  EXPECT_NEAR(error.azimuth_deg, -70, 1e-9);
  EXPECT_NEAR(error.pitch_deg, 5, 1e-9);
  EXPECT_NEAR(error.roll_deg, -12, 1e-9);
  EXPECT_NEAR(error.tilt_deg, 13, 1e-9);
}

TEST(Orientation, PitchLeansForwards) {
  const Eigen::Matrix3d R = Tilt(10, 0);
  EXPECT_GT(R.col(1).z(), 0) << "the top moves to the front";
  EXPECT_NEAR(CompareOrientation(R, Eigen::Matrix3d::Identity(), 1).pitch_deg, 10, 1e-9);
}

TEST(Orientation, TiltIsBetweenTheYAxes) {
  const Eigen::Matrix3d R = ExpSO3({0.3, 0.8, -0.5});
  const double angle = std::acos(R.col(1).dot(Eigen::Vector3d::UnitY())) / kDegree;
  EXPECT_NEAR(CompareOrientation(kTrue * R, kTrue, 1).tilt_deg, angle, 1e-9);
}

TEST(Orientation, SymmetricTurnsAreNoError) {
  EXPECT_NEAR(CompareOrientation(kTrue * Turn(180), kTrue, 2).azimuth_deg, 0, 1e-9);
  EXPECT_NEAR(std::abs(CompareOrientation(kTrue * Turn(180), kTrue, 1).azimuth_deg), 180, 1e-9);
  EXPECT_NEAR(CompareOrientation(kTrue * Turn(170), kTrue, 2).azimuth_deg, -10, 1e-9);
  const OrientationError quarter = CompareOrientation(kTrue * Turn(93) * Tilt(4, 0), kTrue, 4);
  EXPECT_EQ(quarter.symmetry_step, 1);
  EXPECT_NEAR(quarter.azimuth_deg, 3, 1e-9);
  EXPECT_NEAR(quarter.pitch_deg, 4, 1e-9) << "about the estimate's own axis";
}

TEST(Orientation, UpsideDown) {
  const OrientationError error = CompareOrientation(kTrue * Tilt(180, 0), kTrue, 1);
  EXPECT_NEAR(error.tilt_deg, 180, 1e-6);
  EXPECT_FALSE(std::isnan(error.azimuth_deg));
}

}  // namespace
}  // namespace armature
