// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/object_tracks.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "association/box_constraints.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

// Yaw is the direction of the object's front about the up axis, from the odometry's x axis... any fixed horizontal one.
constexpr double kVoteSigma = 12 * kDegree;
constexpr double kVoteOutliers = 0.05;

// Two fixed axes of the odometry's frame that span the plane to which an upright object's y axis is normal.
void HorizontalAxes(const Eigen::Vector3d& up, Eigen::Vector3d& zero, Eigen::Vector3d& quarter) {
  // The camera's first optical axis is seldom vertical.
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  zero = (z - z.dot(up) * up);
  if (zero.norm() < 0.1) zero = up.unitOrthogonal();
  zero.normalize();
  quarter = up.cross(zero);
}

}  // namespace

Eigen::Vector3d ObjectTracks::ExpectedTranslation(const Track& track, const Eigen::Isometry3d& T_odom_camera) const {
  return T_odom_camera.linear().transpose() * (track.position - scale_ * T_odom_camera.translation());
}

Box ObjectTracks::ExpectedBox(const Track& track, const Camera& camera, const Eigen::Isometry3d& T_odom_camera) const {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = T_odom_camera.linear().transpose() * track.R_odom_object;
  T.translation() = ExpectedTranslation(track, T_odom_camera);
  ProjectedWireframe projected;
  const Box image{0, 0, camera.width - 1.0, camera.height - 1.0};
  ProjectWireframe(camera, track.model->spec, WireframeFromCoefficients(*track.model, track.shape), T, image, {},
                   projected);
  const std::array<ExtremePoint, 4> extremes = Extremes(projected);
  if (extremes[0].edge < 0) return {};
  return {extremes[0].pixel, extremes[1].pixel, extremes[2].pixel - extremes[0].pixel,
          extremes[3].pixel - extremes[1].pixel};
}

std::vector<int> ObjectTracks::Associate(double timestamp, const std::vector<ObjectView>& views,
                                         const Eigen::Isometry3d& T_odom_camera) const {
  std::vector<int> result(views.size(), -1);
  std::vector<std::tuple<double, size_t, size_t>> pairs;  // negative score, view, track
  for (size_t t = 0; t < tracks_.size(); ++t) {
    if (timestamp - tracks_[t].last_seen > options_.max_gap || views.empty()) continue;
    const Box expected = ExpectedBox(tracks_[t], *views.front().camera, T_odom_camera);
    for (size_t v = 0; v < views.size(); ++v) {
      if (views[v].model != tracks_[t].model) continue;
      const Box& seen = views[v].detection.box;
      // What is seen may be only a part of what is expected, so being inside counts too.
      const double inside = Intersection(expected, seen).area() / std::max(seen.area(), 1.0);
      const double overlap = IntersectionOverUnion(expected, seen);
      if (overlap > 0.25 || (inside > 0.7 && overlap > 0.1)) pairs.emplace_back(-overlap - 0.3 * inside, v, t);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<bool> taken(tracks_.size(), false);
  for (const auto& [score, v, t] : pairs) {
    if (result[v] >= 0 || taken[t]) continue;
    result[v] = static_cast<int>(t);
    taken[t] = true;
  }
  return result;
}

std::optional<ObjectMemory> ObjectTracks::Recall(int index, const Eigen::Isometry3d& T_odom_camera) const {
  if (index < 0) return std::nullopt;
  const Track& track = tracks_[static_cast<size_t>(index)];
  if (track.observations < options_.min_observations) return std::nullopt;
  const Eigen::Matrix3d R_camera_odom = T_odom_camera.linear().transpose();
  ObjectMemory memory;
  memory.expected.T_camera_object.linear() = R_camera_odom * track.R_odom_object;
  memory.expected.T_camera_object.translation() = ExpectedTranslation(track, T_odom_camera);
  const double distance = memory.expected.T_camera_object.translation().norm();
  if (memory.expected.T_camera_object.translation().z() < 0.1) return std::nullopt;
  const double least = std::max(options_.min_sigma, options_.min_relative_sigma * distance);
  memory.position_covariance = R_camera_odom * track.covariance * R_camera_odom.transpose();
  memory.position_covariance.diagonal().array() += least * least;
  const double n = track.observations;
  memory.expected.coefficients = n / (n + 2) * track.shape;
  memory.shape_sigma = std::max(0.4, 1 / std::sqrt(1 + 0.3 * n));
  memory.yaw = track.yaw;
  const Eigen::Vector3d up = track.R_odom_object.col(1);
  HorizontalAxes(up, memory.yaw_zero, memory.yaw_quarter);
  memory.yaw_zero = R_camera_odom * memory.yaw_zero;
  memory.yaw_quarter = R_camera_odom * memory.yaw_quarter;
  return memory;
}

void ObjectTracks::Vote(Track& track, const ObjectView& view, const ObjectEstimation& estimation,
                        const Eigen::Isometry3d& T_odom_camera) const {
  if (!view.detection.azimuth) return;
  const Eigen::Isometry3d& T = estimation.measured.T_camera_object;
  // Turning the estimate to the prior's azimuth gives the prior's front.
  const double azimuth = ViewpointFromRotation(T.linear(), T.translation()).azimuth;
  const Eigen::Matrix3d R = T_odom_camera.linear() * T.linear() *
                            Eigen::AngleAxisd(azimuth - *view.detection.azimuth, Eigen::Vector3d::UnitY());
  Eigen::Vector3d zero, quarter;
  HorizontalAxes(R.col(1), zero, quarter);
  const double voted = std::atan2(R.col(2).dot(quarter), R.col(2).dot(zero));
  double least = 1e9;
  for (int bin = 0; bin < YawBelief::kBins; ++bin) {
    const double yaw = (bin + 0.5) * 2 * M_PI / YawBelief::kBins - M_PI;
    const double off = AzimuthDifference(yaw, voted, track.model->spec.symmetry_order) / kVoteSigma;
    double& cost = track.yaw.cost[static_cast<size_t>(bin)];
    cost = options_.fading * cost - options_.vote_weight *
                                        std::log((1 - kVoteOutliers) * std::exp(-0.5 * off * off) + 0.1 * kVoteOutliers);
    least = std::min(least, cost);
  }
  for (double& cost : track.yaw.cost) cost -= least;
}

void ObjectTracks::Learn(int index, double timestamp, const ObjectView& view, const ObjectEstimation& estimation,
                         const Eigen::Isometry3d& T_odom_camera) {
  if (index < 0) {
    tracks_.emplace_back();
    index = static_cast<int>(tracks_.size()) - 1;
    tracks_.back().model = view.model;
    tracks_.back().shape = Eigen::VectorXd::Zero(view.model->modes());
  }
  Track& track = tracks_[static_cast<size_t>(index)];
  const Eigen::Vector3d t = estimation.measured.T_camera_object.translation();
  const Eigen::Vector3d ray = t.normalized();
  Eigen::Matrix3d covariance = estimation.measured_covariance.bottomRightCorner<3, 3>() * options_.measurement_scale *
                               options_.measurement_scale;
  // The expected distance, not the measured one: near errors would weigh more than far ones.
  const bool known = track.observations >= options_.min_observations;
  const double distance = known ? ExpectedTranslation(track, T_odom_camera).norm() : t.norm();
  const double depth_sigma = options_.depth_sigma * distance;
  const double lateral_sigma = options_.lateral_sigma * distance;
  covariance += depth_sigma * depth_sigma * ray * ray.transpose() +
                lateral_sigma * lateral_sigma * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d R = T_odom_camera.linear();
  const Eigen::Matrix3d information = (R * covariance * R.transpose()).inverse();
  // y = [I, -c] (p, s)
  Eigen::Matrix<double, 3, 4> A;
  A << Eigen::Matrix3d::Identity(), -T_odom_camera.translation();
  double weight = 1;
  if (known) {
    const Eigen::Vector3d off = R * (t - ExpectedTranslation(track, T_odom_camera));
    weight = 1 / (1 + off.dot((track.covariance + information.inverse()).llt().solve(off)) / 6);
  }
  track.normal = options_.fading * track.normal + weight * A.transpose() * information * A;
  track.right_side = options_.fading * track.right_side + weight * A.transpose() * information * (R * t);
  const double gain = std::max(0.08, 1.0 / (track.observations + 1));
  track.shape += weight * gain * (estimation.measured.coefficients - track.shape);
  track.R_odom_object = R * estimation.estimate.T_camera_object.linear();
  track.last_seen = timestamp;
  ++track.observations;
  Vote(track, view, estimation, T_odom_camera);
}

std::optional<double> ObjectTracks::Scale() const {
  if (scale_sigma_ > 0.1 * scale_) return std::nullopt;
  return scale_;
}

void ObjectTracks::Update(double timestamp) {
  std::erase_if(tracks_, [&](const Track& track) { return timestamp - track.last_seen > options_.max_gap; });
  // Eliminate every p: what remains is one equation for s.
  double information = 1 / (options_.scale_sigma * options_.scale_sigma), right_side = information;
  for (const Track& track : tracks_) {
    const Eigen::Matrix3d pp = track.normal.topLeftCorner<3, 3>();
    const Eigen::Vector3d ps = track.normal.topRightCorner<3, 1>();
    const Eigen::Vector3d by_p = pp.llt().solve(ps);
    information += track.normal(3, 3) - ps.dot(by_p);
    right_side += track.right_side(3) - by_p.dot(track.right_side.head<3>());
  }
  scale_ = std::max(0.0, right_side / information);
  scale_sigma_ = 1 / std::sqrt(information);
  for (Track& track : tracks_) {
    const Eigen::LLT<Eigen::Matrix3d> pp(track.normal.topLeftCorner<3, 3>());
    track.position = pp.solve(track.right_side.head<3>() - scale_ * track.normal.topRightCorner<3, 1>());
    track.covariance = pp.solve(Eigen::Matrix3d::Identity());
  }
}

}  // namespace armature
