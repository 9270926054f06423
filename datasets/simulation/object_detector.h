// SPDX-License-Identifier: BSD-3-Clause
// How one object is detected, from frame to frame.
#pragma once

#include <cstdint>
#include <vector>

#include "datasets/simulation/box_errors.h"
#include "datasets/simulation/detections.h"
#include "datasets/simulation/stretches.h"
#include "datasets/simulation/viewpoint_errors.h"

namespace armature {

// Of a category: not too little, and not too small.
bool IsDetectable(const VisibleObject& visible, const DetectionNoise& noise);

// The category that a detector confuses this one with, or takes the distractor's shape for; empty: none.
std::string LooksLike(const std::string& category_or_shape);

class ObjectDetector {
 public:
  // `number` of the object in the scene, from 1.
  ObjectDetector(int number, std::uint64_t seed);

  // The object's detections in a frame in which it is `seen`: none, its own, a duplicate, one of a wrong
  // category. `random`: what is drawn for this frame alone.
  std::vector<SimulatedDetection> Detect(const SeenFrame& frame, const VisibleObject& seen,
                                         const DetectableScene& scene, const DetectorNoise& noise,
                                         Random& random);

 private:
  // A box that comes and goes, with a view and errors of its own.
  struct Extra {
    explicit Extra(std::uint64_t seed) : random(seed), box(seed + 1), viewpoint(seed + 2) {}

    Random random;
    Stretches stretches;
    BoxErrors box;
    ViewpointErrors viewpoint;
  };

  bool IsMissed(const VisibleObject& seen, const DetectionNoise& noise, double time, Random& random);
  Box SeenBox(const SeenFrame& frame, const VisibleObject& seen, const DetectableScene& scene,
              const DetectionNoise& noise);
  void AddMistaken(const SeenFrame& frame, const VisibleObject& seen, const DetectableScene& scene,
                   const DetectorNoise& noise, std::vector<SimulatedDetection>* found);
  void AddDuplicate(const SeenFrame& frame, const VisibleObject& seen, const Box& box,
                    const DetectableScene& scene, const DetectionNoise& noise,
                    std::vector<SimulatedDetection>* found);

  const DetectableObject& Object(const DetectableScene& scene) const;

  int number_;
  double difficulty_;  // standard normal: of log odds of a miss
  Random random_;
  Stretches missed_, spanning_;
  PartBoxes part_;
  BoxErrors box_;
  ViewpointErrors viewpoint_;
  Extra duplicate_, mistaken_;
};

}  // namespace armature
