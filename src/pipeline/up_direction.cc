// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/up_direction.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

// Cauchy weight of an angle in standard deviations.
double RobustWeight(double sigmas) { return 1 / (1 + sigmas * sigmas / 4); }

// A unit vector's information: the quadratic form that costs angle^2 / sigma^2.
Eigen::Matrix3d DirectionInformation(const Eigen::Vector3d& direction, double sigma) {
  return (Eigen::Matrix3d::Identity() - direction * direction.transpose()) / (sigma * sigma);
}

}  // namespace

UpEstimator::FrameEvidence UpEstimator::Observe(const Camera& camera, const std::vector<Segment>& segments,
                                                const std::vector<Detection>& detections,
                                                const Eigen::Matrix3d& R_odom_camera) const {
  FrameEvidence evidence;
  const size_t count = std::min(segments.size(), static_cast<size_t>(options_.segments_per_frame));
  for (size_t i = 0; i < count; ++i) {  // the longest come first
    const Eigen::Vector3d normal = camera.Ray(segments[i].p1).cross(camera.Ray(segments[i].p2));
    evidence.plane_normals.push_back(R_odom_camera * normal.normalized());
    evidence.weights.push_back(std::min(1.0, segments[i].length() / 100));
  }
  for (const Detection& detection : detections) {
    if (!detection.elevation || !detection.tilt) continue;
    const Viewpoint viewpoint{0, *detection.elevation, *detection.tilt};
    const Eigen::Matrix3d R = RotationFromViewpoint(viewpoint, camera.Ray(detection.box.center()));
    evidence.viewpoint_ups.push_back(R_odom_camera * R.col(1));
  }
  evidence.level_up = R_odom_camera * Eigen::Vector3d(0, -1, 0);
  return evidence;
}

// The robust mean of what viewpoints and the level camera say.
Eigen::Vector3d UpEstimator::RoughUp() const {
  const double viewpoint_sigma = options_.viewpoint_sigma_deg * kDegree, level_sigma = options_.level_sigma_deg * kDegree;
  Eigen::Vector3d up = Eigen::Vector3d::Zero();
  for (const FrameEvidence& frame : window_) {
    up += frame.level_up / (level_sigma * level_sigma);
    for (const Eigen::Vector3d& vote : frame.viewpoint_ups) up += vote / (viewpoint_sigma * viewpoint_sigma);
  }
  up.normalize();
  for (int iteration = 0; iteration < 5; ++iteration) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const FrameEvidence& frame : window_) {
      const auto add = [&](const Eigen::Vector3d& vote, double sigma) {
        sum += RobustWeight(std::acos(std::clamp(up.dot(vote), -1.0, 1.0)) / sigma) / (sigma * sigma) * vote;
      };
      add(frame.level_up, level_sigma);
      for (const Eigen::Vector3d& vote : frame.viewpoint_ups) add(vote, viewpoint_sigma);
    }
    up = sum.normalized();
  }
  return up;
}

UpEstimate UpEstimator::Update(const Camera& camera, const std::vector<Segment>& segments,
                               const std::vector<Detection>& detections,
                               const std::optional<Eigen::Isometry3d>& T_odom_camera) {
  if (!T_odom_camera) window_.clear();
  Eigen::Matrix3d R_odom_camera = Eigen::Matrix3d::Identity();
  if (T_odom_camera) R_odom_camera = T_odom_camera->linear();
  window_.push_back(Observe(camera, segments, detections, R_odom_camera));
  if (window_.size() > static_cast<size_t>(options_.window_frames)) window_.pop_front();

  const Eigen::Vector3d rough = RoughUp();
  size_t votes = 0;
  for (const FrameEvidence& frame : window_) votes += frame.viewpoint_ups.size();
  // The rough direction's own uncertainty; correlated errors keep it from falling below a degree.
  const double viewpoint_sigma = options_.viewpoint_sigma_deg * kDegree;
  const double rough_sigma =
      votes > 0 ? std::max(1 * kDegree, viewpoint_sigma / std::sqrt(static_cast<double>(votes)))
                : options_.level_sigma_deg * kDegree;
  Eigen::Vector3d up = rough;
  Eigen::Matrix3d information;
  double cone = std::min(options_.cone_deg * kDegree, 3 * rough_sigma + 2 * kDegree);
  const double segment_sigma = options_.segment_sigma_deg * kDegree;
  for (int iteration = 0; iteration < 8; ++iteration, cone = std::max(0.6 * cone, 2.5 * segment_sigma)) {
    // Smallest eigenvector of sum w n n^T: the direction that the planes have in common.
    information = DirectionInformation(rough, rough_sigma);
    for (const FrameEvidence& frame : window_) {
      for (size_t i = 0; i < frame.plane_normals.size(); ++i) {
        const Eigen::Vector3d& n = frame.plane_normals[i];
        const double off = std::asin(std::clamp(n.dot(up), -1.0, 1.0));
        if (std::abs(off) > cone) continue;
        const double bisquare = 1 - off * off / (cone * cone);
        // Neighbouring frames see the same lines: each counts for a fraction.
        const double share = 1.0 / static_cast<double>(std::min<size_t>(window_.size(), 15));
        information += share * frame.weights[i] * bisquare * bisquare / (segment_sigma * segment_sigma) * n * n.transpose();
      }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(information);
    up = solver.eigenvectors().col(0);
    if (up.dot(rough) < 0) up = -up;
  }
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(information).eigenvalues()(1);
  return {R_odom_camera.transpose() * up, 1 / std::sqrt(std::max(least, 1.0))};
}

}  // namespace armature
