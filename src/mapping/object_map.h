// SPDX-License-Identifier: BSD-3-Clause
// The map while frames come in.
#pragma once

#include <map>
#include <vector>

#include "mapping/solve_map.h"
#include "odometry/unit_change.h"

namespace armature {

inline constexpr int kFirstSolve = 30;  // frames after which the map is solved for the first time

// The factor graph is solved anew now and then: whenever the frames have become so many times more. Between
// two solutions the cameras follow the odometry. Of a place that is seen again and again some frames are kept
// (keyframes.h), so a room that is known costs no more, however long the video.
class ObjectMap {
 public:
  ObjectMap(const MappingOptions& options, const BoxOptions& box, const ResectionOptions& resection)
      : options_(options), box_(box), resection_(resection) {}

  // `expected_scale`: of the odometry, as the front end has learnt it so far; sigma 0: known.
  void Add(MapFrame frame, const ScaleEstimate& expected_scale);

  // Frames since a change of the odometry's unit were added in the new one.
  void Undo(const UnitChange& change);

  // Objects and the cameras of the kept frames as known after the last frame; those of objects without the
  // joint refinement.
  const Map& current() const { return current_; }

  // The kept ones.
  const std::vector<MapFrame>& frames() const { return frames_; }

  // The batch solution of the kept frames, with the joint refinement. At least one frame.
  Map Solve(const ScaleEstimate& expected_scale) const;

  // A map of the kept frames with the cameras and detections of all.
  Map WithAllFrames(const Map& map) const;

 private:
  void RememberObjects();
  void Pass(size_t index);
  void FollowOdometry(double scale);

  MappingOptions options_;
  BoxOptions box_;
  ResectionOptions resection_;
  std::vector<MapFrame> frames_;
  Map current_;
  std::map<int, int> joined_tracks_;  // track of the front end to that which the map has joined it to
  double added_ = 0;                  // frames so far
  double next_solve_ = 0;             // frames
};

}  // namespace armature
