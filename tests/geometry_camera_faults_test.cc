// SPDX-License-Identifier: BSD-3-Clause
// Intrinsics that no camera has, and those that are only unusual.
#include <gtest/gtest.h>

#include "geometry/camera_faults.h"

namespace armature {
namespace {

const Camera kUsual{856, 480, 580, 580, 427.5, 239.5};

Camera WithDistortion(const std::array<double, 5>& distortion) {
  Camera camera = kUsual;
  camera.distortion = distortion;
  return camera;
}

void ExpectFault(const Camera& camera, const std::string& key, bool is_impossible) {
  const auto faults = FindCameraFaults(camera);
  ASSERT_FALSE(faults.empty()) << key;
  EXPECT_EQ(faults[0].key, key);
  EXPECT_EQ(faults[0].is_impossible, is_impossible) << faults[0].what;
}

TEST(CameraFaults, AreNotInUsualCameras) {
  EXPECT_TRUE(FindCameraFaults(kUsual).empty());
  // Of public calibrations: a phone, EuRoC's, a wide action camera, a telephoto lens.
  for (const auto& k : {std::array{0.12, -0.28, 0.001, -0.001, 0.18},
                        {-0.283, 0.074, 0.0002, 1.8e-05, 0.0},
                        {-0.25, 0.09, 0.0, 0.0, -0.015}})
    EXPECT_TRUE(FindCameraFaults(WithDistortion(k)).empty());
  EXPECT_TRUE(FindCameraFaults({856, 480, 30000, 30000, 427.5, 239.5, {-8, 0, 0, 0, 0}}).empty());
}

TEST(CameraFaults, AreFoundByTheirKey) {
  Camera normalised{856, 480, 0.6776, 1.2083, 0.4994, 0.499};
  ExpectFault(normalised, "fx", true);
  Camera camera = kUsual;
  camera.fx = 1e9;
  ExpectFault(camera, "fx", true);
  camera.fx = 290 / 3.0;
  ExpectFault(camera, "fx", true);  // a sixth of fy
  camera.fx = 200;
  ExpectFault(camera, "fx", false);
  camera = kUsual;
  camera.cx = 5000;
  ExpectFault(camera, "cx", true);
  camera.cx = 900;
  ExpectFault(camera, "cx", false);
  camera = kUsual;
  camera.height = 70000;
  ExpectFault(camera, "height", true);
}

// r + k1 r^3 turns back at r = 1 / sqrt(-3 k1), which it brings to 2/3 of that: the corner is at 0.845.
TEST(CameraFaults, KnowADistortionThatFoldsInsideTheImage) {
  ExpectFault(WithDistortion({-0.21, 0, 0, 0, 0}), "distortion", true);
  EXPECT_TRUE(FindCameraFaults(WithDistortion({-0.20, 0, 0, 0, 0})).empty());
  ExpectFault(WithDistortion({0.1, -0.5, 0, 0, 0}), "distortion", true);
}

TEST(CameraFaults, KnowADistortionThatIsTooStrong) {
  ExpectFault(WithDistortion({1e6, 0, 0, 0, 0}), "distortion", true);
  ExpectFault(WithDistortion({0, 0, 3, 0, 0}), "distortion", true);
  ExpectFault(WithDistortion({12, 0, 0, 0, 0}), "distortion", false);
}

}  // namespace
}  // namespace armature
