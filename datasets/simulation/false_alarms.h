// SPDX-License-Identifier: BSD-3-Clause
// Detections of what is no object.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "datasets/simulation/detections.h"
#include "datasets/simulation/object_detector.h"

namespace armature {

// One for a frame alone, anywhere, of a category of the scene's objects (at least one).
Detection RandomFalseAlarm(const DetectableScene& scene, Random& random);

// A whole number of that mean.
int DrawCount(double mean, Random& random);

// A distractor that is taken for furniture, for stretches of time.
class DistractorDetector {
 public:
  DistractorDetector(const std::string& shape, std::uint64_t seed);

  std::optional<Detection> Detect(const SeenFrame& frame, const VisibleObject& seen,
                                  const DetectableScene& scene, const DetectorNoise& noise);

 private:
  std::string category_;  // empty: it looks like nothing that is detected
  Random random_;
  Eigen::Matrix3d R_world_object_;  // as the viewpoint estimator sees it
  Stretches stretches_;
  BoxErrors box_;
  ViewpointErrors viewpoint_;
};

// False alarms of one category on things in the background: each stays at its place in the world while it
// lasts and is in the picture.
class BackgroundAlarms {
 public:
  BackgroundAlarms(const std::string& category, std::uint64_t seed) : category_(category), random_(seed) {}

  std::vector<Detection> Detect(const SeenFrame& frame, const DetectableScene& scene,
                                const DetectionNoise& noise);

 private:
  struct Alarm {
    double until = 0;  // seconds
    Eigen::Vector3d centre_world;
    Eigen::Vector2d size;  // metres
    Eigen::Matrix3d R_world_object;
    BoxErrors box;
    ViewpointErrors viewpoint;
  };

  void Begin(const SeenFrame& frame, const Camera& camera, const DetectionNoise& noise);

  std::string category_;
  Random random_;
  std::optional<double> last_time_;
  std::vector<Alarm> alarms_;
};

}  // namespace armature
