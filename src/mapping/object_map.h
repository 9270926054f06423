// SPDX-License-Identifier: BSD-3-Clause
// The map while frames come in.
#pragma once

#include <vector>

#include "mapping/solve_map.h"

namespace armature {

inline constexpr int kFirstSolve = 30;  // frames after which the map is solved for the first time

// The factor graph is solved anew now and then, at a fixed cost a frame on average: whenever the frames have
// become so many times more. Between two solutions the cameras follow the odometry.
class ObjectMap {
 public:
  // `odometry_is_metric`: its unit is the metre; otherwise the objects tell its scale.
  ObjectMap(const MappingOptions& options, const BoxOptions& box, const ResectionOptions& resection,
            bool odometry_is_metric)
      : options_(options), box_(box), resection_(resection), odometry_is_metric_(odometry_is_metric) {}

  // `expected_scale`: of the odometry, as the front end has learnt it so far.
  void Add(MapFrame frame, const ScaleEstimate& expected_scale);

  // Cameras and objects as known after the last frame; those of objects without the joint refinement.
  const Map& current() const { return current_; }

  const std::vector<MapFrame>& frames() const { return frames_; }

  // The batch solution of all frames, with the joint refinement. At least one frame.
  Map Solve(const ScaleEstimate& expected_scale) const;

 private:
  ScaleEstimate Expected(const ScaleEstimate& learnt) const;
  void FollowOdometry(double scale);

  MappingOptions options_;
  BoxOptions box_;
  ResectionOptions resection_;
  bool odometry_is_metric_;
  std::vector<MapFrame> frames_;
  Map current_;
  double next_solve_ = 0;  // frames
};

}  // namespace armature
