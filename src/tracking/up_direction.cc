// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/up_direction.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

// Tuned on office_dev and redkitchen_a.
constexpr size_t kWindowFrames = 120;             // whose evidence is kept
constexpr size_t kSegmentsPerFrame = 40;          // that vote, the longest
constexpr double kVerticalSigma = 0.7 * kDegree;  // standard deviation of a vertical segment's plane

// Of viewpoints that all err alike, and how far lines may be from upright about where they are tried, at
// first.
constexpr double kViewpointBias = 8 * kDegree, kViewpointCone = 7 * kDegree;

// Of up as it was estimated before, in the odometry's frame, which drifts.
constexpr double kMemorySigma = 1.5 * kDegree, kMemoryCone = 6 * kDegree, kClearlyBetter = 1.5;

// Cauchy weight of an angle in standard deviations.
double RobustWeight(double sigmas) { return 1 / (1 + sigmas * sigmas / 4); }

// A unit vector's information: the quadratic form that costs angle^2 / sigma^2.
Eigen::Matrix3d DirectionInformation(const Eigen::Vector3d& direction, double sigma) {
  return (Eigen::Matrix3d::Identity() - direction * direction.transpose()) / (sigma * sigma);
}

}  // namespace

std::optional<UpVote> MakeUpVote(const Detection& detection, const Eigen::Vector3d& ray, double sigma_deg) {
  if (!detection.elevation || !detection.tilt) return std::nullopt;
  const Viewpoint viewpoint{0, *detection.elevation, *detection.tilt};
  return UpVote{RotationFromViewpoint(viewpoint, ray).col(1), sigma_deg * kDegree};
}

UpEstimator::FrameEvidence UpEstimator::Observe(const Camera& camera, const std::vector<Segment>& segments,
                                                const Eigen::Matrix3d& R_odom_camera) const {
  FrameEvidence evidence;
  evidence.R_odom_camera = R_odom_camera;
  const size_t count = std::min(segments.size(), kSegmentsPerFrame);
  for (size_t i = 0; i < count; ++i) {  // the longest come first
    const Eigen::Vector3d normal = camera.Ray(segments[i].p1).cross(camera.Ray(segments[i].p2));
    evidence.plane_normals.push_back(R_odom_camera * normal.normalized());
    evidence.weights.push_back(std::min(1.0, segments[i].length() / 100));
  }
  return evidence;
}

void UpEstimator::Update(const std::vector<UpVote>& votes) {
  if (window_.empty()) return;
  FrameEvidence& frame = window_.back();
  frame.votes = {{frame.R_odom_camera * Eigen::Vector3d(0, -1, 0), kLevelSigmaDeg * kDegree}};
  for (const UpVote& vote : votes) frame.votes.push_back({frame.R_odom_camera * vote.up_camera, vote.sigma});
}

// The robust mean of what viewpoints and the level camera say.
Eigen::Vector3d UpEstimator::RoughUp() const {
  Eigen::Vector3d up = Eigen::Vector3d::Zero();
  for (int iteration = 0; iteration < 6; ++iteration) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const FrameEvidence& frame : window_) {
      for (const UpVote& vote : frame.votes) {
        // The first time every vote counts in full.
        const double angle = iteration == 0 ? 0 : std::acos(std::clamp(up.dot(vote.up_camera), -1.0, 1.0));
        sum += RobustWeight(angle / vote.sigma) / (vote.sigma * vote.sigma) * vote.up_camera;
      }
    }
    up = sum.normalized();
  }
  return up;
}

// The direction that most segments' planes share near `start`: smallest eigenvector of sum w n n^T with
// weights that narrow from round to round, and what the votes say.
UpEstimator::Refined UpEstimator::Refine(const Eigen::Vector3d& start, double cone,
                                         const Eigen::Vector3d& rough, double rough_sigma) const {
  // Neighbouring frames see the same lines: each counts for a fraction.
  const double share = 1.0 / static_cast<double>(std::min<size_t>(window_.size(), 15));
  Refined refined{start, Eigen::Matrix3d::Zero(), 0};
  for (int iteration = 0; iteration < 8; ++iteration, cone = std::max(0.6 * cone, 2.5 * kVerticalSigma)) {
    refined.information = DirectionInformation(rough, rough_sigma);
    refined.support = 0;
    const double outside = std::sin(cone);  // most segments are, and need no arcus
    for (const FrameEvidence& frame : window_) {
      for (size_t i = 0; i < frame.plane_normals.size(); ++i) {
        const Eigen::Vector3d& n = frame.plane_normals[i];
        const double sine = n.dot(refined.up);
        if (std::abs(sine) > outside) continue;
        const double off = std::asin(sine);
        const double bisquare = 1 - off * off / (cone * cone);
        const double weight = share * frame.weights[i] * bisquare * bisquare;
        refined.support += weight;
        refined.information += weight / (kVerticalSigma * kVerticalSigma) * n * n.transpose();
      }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(refined.information);
    refined.up = solver.eigenvectors().col(0);
    if (refined.up.dot(rough) < 0) refined.up = -refined.up;
  }
  return refined;
}

// Viewpoints of a network may all be off by ten or twenty degrees in the same way, for a whole room: they
// tell which bundle of parallel lines is vertical, and the lines tell up.
UpEstimator::Refined UpEstimator::RefineNearViewpoints(const Eigen::Vector3d& rough) const {
  const Eigen::Vector3d right = window_.back().R_odom_camera.col(0);
  Refined best;
  double most = -1;
  for (const double pitch_deg : {0.0, 8.0, -8.0, 16.0, -16.0}) {
    const Eigen::Vector3d start = Eigen::AngleAxisd(pitch_deg * kDegree, right) * rough;
    const Refined refined = Refine(start, kViewpointCone, rough, kViewpointBias);
    const double off = std::acos(std::clamp(refined.up.dot(rough), -1.0, 1.0)) / kViewpointBias;
    const double support = refined.support * std::exp(-0.5 * off * off);
    if (support <= most) continue;
    most = support;
    best = refined;
  }
  if (!last_up_odom_) return best;
  // Up stays where it is in the odometry's frame: another direction has to be clearly better.
  const Refined as_before = Refine(*last_up_odom_, kMemoryCone, *last_up_odom_, kMemorySigma);
  return most > kClearlyBetter * as_before.support ? best : as_before;
}

// Where no detection has a viewpoint, the level camera is all that is roughly known, and people look down at
// furniture: several pitches are tried, and the one whose verticals are most wins.
UpEstimator::Refined UpEstimator::RefineFromPitches(const Eigen::Vector3d& rough, double rough_sigma) const {
  const Eigen::Vector3d right = window_.back().R_odom_camera.col(0);
  Refined best{rough, Eigen::Matrix3d::Zero(), -1};
  for (const double pitch_deg : {0.0, 12.0, 24.0, 36.0, 48.0, -12.0}) {
    const Eigen::Vector3d start = Eigen::AngleAxisd(pitch_deg * kDegree, right) * rough;
    const Refined refined = Refine(start, 10 * kDegree, rough, rough_sigma);
    if (refined.support > best.support) best = refined;
  }
  return best;
}

UpEstimate UpEstimator::Predict(const Camera& camera, const std::vector<Segment>& segments,
                                const std::vector<UpVote>& votes,
                                const std::optional<Eigen::Isometry3d>& T_odom_camera) {
  if (!T_odom_camera) {
    window_.clear();
    last_up_odom_.reset();
  }
  Eigen::Matrix3d R_odom_camera = Eigen::Matrix3d::Identity();
  if (T_odom_camera) R_odom_camera = T_odom_camera->linear();
  window_.push_back(Observe(camera, segments, R_odom_camera));
  Update(votes);
  if (window_.size() > kWindowFrames) window_.pop_front();

  const Eigen::Vector3d rough = RoughUp();
  const bool has_viewpoints = std::any_of(window_.begin(), window_.end(), [](const FrameEvidence& frame) {
    return frame.votes.size() > 1;  // the first is the level camera
  });
  const Refined refined =
      has_viewpoints ? RefineNearViewpoints(rough) : RefineFromPitches(rough, kLevelSigmaDeg * kDegree);
  if (T_odom_camera) last_up_odom_ = refined.up;
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(refined.information).eigenvalues()(1);
  return {R_odom_camera.transpose() * refined.up, 1 / std::sqrt(std::max(least, 1.0))};
}

}  // namespace armature
