// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/object_map.h"

#include <algorithm>
#include <utility>

namespace armature {
namespace {

constexpr double kSolveGrowth = 1.4;  // and again whenever there are this many times more frames

}  // namespace

ScaleEstimate ObjectMap::Expected(const ScaleEstimate& learnt) const {
  return odometry_is_metric_ ? ScaleEstimate{1, 0} : learnt;
}

void ObjectMap::Add(MapFrame frame, const ScaleEstimate& expected_scale) {
  frames_.push_back(std::move(frame));
  const auto count = static_cast<double>(frames_.size());
  if (count < std::max<double>(kFirstSolve, next_solve_)) {
    FollowOdometry(Expected(expected_scale).scale);
    return;
  }
  next_solve_ = count * kSolveGrowth;
  MappingOptions without_refinement = options_;
  without_refinement.refinement.rounds = 0;
  current_ = SolveMap(frames_, Expected(expected_scale), box_, resection_, without_refinement);
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
  return SolveMap(frames_, Expected(expected_scale), box_, resection_, options_);
}

}  // namespace armature
