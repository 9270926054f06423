// SPDX-License-Identifier: BSD-3-Clause
// Stands in for an object detector and a viewpoint estimator.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "association/detection.h"
#include "datasets/simulation/detection_noise.h"
#include "datasets/simulation/visible_objects.h"
#include "geometry/camera.h"

namespace armature {

// What a detection simulator knows of an object.
struct DetectableObject {
  std::string id, category;
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();
};

struct SimulatedDetection {
  Detection detection;
  std::string id;  // of the object; empty: a false alarm
};

// What is found in one picture, by falling score. `objects`: those of the scene, number i + 1 at place i;
// false alarms are of their categories. Viewpoints are seen along the ray through the middle of the box.
std::vector<SimulatedDetection> SimulateDetections(const std::vector<VisibleObject>& visible,
                                                   const std::vector<DetectableObject>& objects,
                                                   const Camera& camera,
                                                   const Eigen::Isometry3d& T_world_camera,
                                                   const DetectionNoise& noise, std::uint64_t seed);

}  // namespace armature
