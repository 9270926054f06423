// SPDX-License-Identifier: BSD-3-Clause
// Stands in for an object detector and a viewpoint estimator, over a whole sequence.
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
  Eigen::Vector3d size{0, 0, 0};  // metres, along the object's axes
};

// Of something that is no object, but may be taken for one.
struct Distractor {
  std::string shape;  // "sofa"
};

struct DetectableScene {
  Camera camera;
  std::vector<DetectableObject> objects;  // number i + 1 at place i
  std::vector<Distractor> distractors;    // number objects.size() + i + 1 at place i
};

struct SeenFrame {
  double timestamp = 0;  // seconds
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  std::vector<VisibleObject> visible;  // objects and distractors, by growing numbers
};

struct SimulatedDetection {
  Detection detection;
  std::string id;  // of the object; empty: a false alarm
};

// What is found in each picture, by falling score; frames by growing stamps. What is found in a frame depends
// on those before it, never on those after it. False alarms are of the objects' categories, or of what a
// distractor looks like. Viewpoints are seen along the ray through the middle of the box.
std::vector<std::vector<SimulatedDetection>> SimulateDetections(const std::vector<SeenFrame>& frames,
                                                                const DetectableScene& scene,
                                                                const DetectorNoise& noise,
                                                                std::uint64_t seed);

}  // namespace armature
