// SPDX-License-Identifier: BSD-3-Clause
// How high the camera is above the floor, learnt from the furniture that stands on it.
//
// One view leaves an object's distance uncertain by some 6 % because its size is; objects that share a floor
// share that distance, and a box that the image cuts on three sides hardly has one of its own. Or it is
// known: a robot's camera is mounted.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "association/object_view.h"
#include "category/category_model.h"
#include "resection/single_view_result.h"

namespace armature {

struct FloorOptions {
  bool enabled = true;
  double initial_height = 1.4;  // metres: a camera held or flown by people in rooms, before anything is seen
  double initial_sigma = 0.4;   // metres, its standard deviation
};

class FloorHeight {
 public:
  // `known`: at all times; nothing is learnt then.
  explicit FloorHeight(const FloorOptions& options, const std::optional<FloorPrior>& known = std::nullopt)
      : options_(options), known_(known), height_(options.initial_height), sigma_(options.initial_sigma) {}

  // The prior for a frame at this time. `climb`: how far the camera rose since the last frame, metres; none
  // where the odometry or its scale is not known.
  std::optional<FloorPrior> Predict(double timestamp, std::optional<double> climb);

  // What an accepted estimate in that frame says; objects that do not stand on the floor say nothing.
  void Update(const SingleViewResult& result, const CategoryModel& model, const Eigen::Vector3d& up_camera);

 private:
  FloorOptions options_;
  std::optional<FloorPrior> known_;
  double height_;  // metres
  double sigma_;   // metres
  std::optional<double> last_timestamp_;
};

// Height of the camera above the lowest point of the wireframe, along up; metres.
double CameraHeightAbove(const Wireframe& wireframe, const Eigen::Isometry3d& T_camera_object,
                         const Eigen::Vector3d& up_camera);

}  // namespace armature
