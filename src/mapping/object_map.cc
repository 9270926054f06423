// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/object_map.h"

#include <algorithm>
#include <utility>

#include "mapping/keyframes.h"

namespace armature {
namespace {

constexpr double kSolveGrowth = 1.4;  // and again whenever there are this many times more frames

}  // namespace

void ObjectMap::Add(MapFrame frame, const ScaleEstimate& expected_scale) {
  for (MapObservation& observation : frame.observations) {
    const auto joined = joined_tracks_.find(observation.track);
    if (joined != joined_tracks_.end()) observation.track = joined->second;
  }
  frames_.push_back(std::move(frame));
  ++added_;
  if (added_ < std::max<double>(kFirstSolve, next_solve_)) {
    FollowOdometry(expected_scale.scale);
  } else {
    next_solve_ = added_ * kSolveGrowth;
    MappingOptions without_refinement = options_;
    without_refinement.refinement.rounds = 0;
    current_ = SolveMap(frames_, expected_scale, box_, resection_, without_refinement);
    if (frames_.size() >= kAlwaysKept) RememberObjects();
  }
  while (const auto superfluous = FindSuperfluousFrame(frames_, current_.T_world_camera)) Pass(*superfluous);
}

void ObjectMap::Undo(const UnitChange& change) {
  const auto undo = [&](double timestamp, Eigen::Isometry3d& T_odom_camera) {
    if (timestamp > change.timestamp) T_odom_camera.translation() = change.Undo(T_odom_camera.translation());
  };
  for (MapFrame& frame : frames_) {
    undo(frame.timestamp, frame.T_odom_camera);
    for (PassedFrame& passed : frame.passed) undo(passed.timestamp, passed.T_odom_camera);
  }
}

// In a long video the same tracks would be found to be one object again and again.
void ObjectMap::RememberObjects() {
  std::map<int, int> first_track;  // of each object
  for (size_t i = 0; i < frames_.size(); ++i) {
    for (size_t j = 0; j < frames_[i].observations.size(); ++j) {
      const int object = current_.phi[i][j];
      if (object < 0) continue;
      MapObservation& observation = frames_[i].observations[j];
      const int track = first_track.emplace(object, observation.track).first->second;
      joined_tracks_[observation.track] = track;
      observation.track = track;
      observation.is_joined = true;
    }
  }
}

void ObjectMap::Pass(size_t index) {
  PassOver(index, frames_);
  const auto at = static_cast<std::ptrdiff_t>(index);
  current_.timestamps.erase(current_.timestamps.begin() + at);
  current_.T_world_camera.erase(current_.T_world_camera.begin() + at);
  current_.phi.erase(current_.phi.begin() + at);
}

void ObjectMap::FollowOdometry(double scale) {
  const MapFrame& frame = frames_.back();
  Eigen::Isometry3d T_last_now = frame.T_odom_camera;
  Eigen::Isometry3d T_world_last = Eigen::Isometry3d::Identity();
  if (frames_.size() > 1) {
    T_last_now = frames_[frames_.size() - 2].T_odom_camera.inverse() * frame.T_odom_camera;
    T_world_last = current_.T_world_camera.back();
  }
  T_last_now.translation() *= scale;
  current_.timestamps.push_back(frame.timestamp);
  current_.T_world_camera.push_back(T_world_last * T_last_now);
  current_.phi.emplace_back(frame.observations.size(), -1);
}

Map ObjectMap::Solve(const ScaleEstimate& expected_scale) const {
  return SolveMap(frames_, expected_scale, box_, resection_, options_);
}

Map ObjectMap::WithAllFrames(const Map& map) const {
  return WithPassedFrames(frames_, map, SecondsBetween(options_));
}

}  // namespace armature
