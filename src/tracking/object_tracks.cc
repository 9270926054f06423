// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/object_tracks.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "association/box_constraints.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

// Tuned on office_dev and redkitchen_a: errors of neighbouring frames are alike, and a filter that believed
// resection's covariances would soon be surer than it is right.
constexpr double kFading = 0.96;         // weight of what was known before, with each new observation
constexpr double kMeasurementScale = 2;  // multiplies the standard deviations of resection
constexpr double kDepthSigma = 0.08;  // share of the distance, added along the ray: one view's error of size
constexpr double kLateralSigma = 0.025;   // share of the distance, added across: bearing, drift, the centre
constexpr double kYawSigmaDeg = 4;        // degrees, added to one view's yaw
constexpr double kTrackShapeSigma = 0.5;  // added to one view's coefficients, standard deviations
// A remembered position (share of the distance), yaw (degrees) and coefficient are never surer than this.
constexpr double kLeastRelativeSigma = 0.03, kLeastYawSigmaDeg = 2, kLeastShapeSigma = 0.4;
constexpr int kObservationsBeforeUse = 2;
constexpr double kLeastSigmasOfGuess = 3;  // of the unit, by which it is not nothing
constexpr double kCaution = 2;             // and then rather too slow: see OdometryUnit
constexpr double kVoteWeight = 0.6;        // of one viewpoint prior; neighbouring frames' are alike
constexpr double kVoteSigma = 12 * kDegree;
constexpr double kVoteOutliers = 0.05;

// Covariance of (position, yaw, shape) with the position's unit changed by the factor.
Eigen::MatrixXd InUnit(const Eigen::MatrixXd& covariance, double factor) {
  Eigen::MatrixXd result = covariance;
  result.topRows<3>() *= factor;
  result.leftCols<3>() *= factor;
  return result;
}

// Two horizontal directions, at yaw 0 and 90 degrees, that stay where they are in the odometry's frame as the
// estimate of up changes a little: the odometry's z axis, the first camera's optical axis, is seldom
// vertical.
struct HorizontalAxes {
  Eigen::Vector3d zero, quarter;

  explicit HorizontalAxes(const Eigen::Vector3d& up) {
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    zero = z - z.dot(up) * up;
    if (zero.norm() < 0.1) zero = up.unitOrthogonal();
    zero.normalize();
    quarter = up.cross(zero);
  }
  double ComputeYaw(const Eigen::Vector3d& front) const {
    return std::atan2(front.dot(quarter), front.dot(zero));
  }
  Eigen::Matrix3d Rotation(double yaw, const Eigen::Vector3d& up) const {
    const Eigen::Vector3d front = std::cos(yaw) * zero + std::sin(yaw) * quarter;
    Eigen::Matrix3d R;
    R << up.cross(front), up, front;
    return R;
  }
};

// The normal equations of a track's z, with the category's shape statistics.
Eigen::LLT<Eigen::MatrixXd> Factorised(Eigen::MatrixXd normal) {
  normal.diagonal().tail(normal.rows() - 4).array() += 1;
  normal.diagonal().head<4>().array() += 1e-6;
  return Eigen::LLT<Eigen::MatrixXd>(normal);
}

}  // namespace

ObjectTracks::Track& ObjectTracks::AddTrack(const CategoryModel& model) {
  Track& track = tracks_.emplace_back();
  track.id = started_++;
  track.model = &model;
  const int n = track.unknowns();
  track.normal = Eigen::MatrixXd::Zero(n + 1, n + 1);
  track.right_side = track.of_cameras = Eigen::VectorXd::Zero(n + 1);
  track.state = Eigen::VectorXd::Zero(n);
  track.covariance = Eigen::MatrixXd::Identity(n, n);
  track.by_units = Eigen::VectorXd::Zero(n);
  return track;
}

const ObjectTracks::Track* ObjectTracks::FindTrack(int id) const {
  const auto found = std::find_if(tracks_.begin(), tracks_.end(), [&](const Track& t) { return t.id == id; });
  return found == tracks_.end() ? nullptr : &*found;
}

PoseAndShape ObjectTracks::Expected(const Track& track, const Eigen::Isometry3d& T_odom_camera,
                                    const Eigen::Vector3d& up_odom) const {
  const Eigen::Matrix3d R_camera_odom = T_odom_camera.linear().transpose();
  PoseAndShape expected;
  expected.T_camera_object.linear() =
      R_camera_odom * HorizontalAxes(up_odom).Rotation(track.state(3), up_odom);
  expected.T_camera_object.translation() =
      R_camera_odom * (track.state.head<3>() - T_odom_camera.translation()) / unit_.units_a_metre();
  expected.coefficients = track.state.tail(track.model->modes());
  return expected;
}

std::vector<ObjectTracks::Pair> ObjectTracks::PairWithViews(double timestamp,
                                                            const std::vector<ObjectView>& views,
                                                            const Eigen::Isometry3d& T_odom_camera) const {
  std::vector<Pair> all;
  for (size_t t = 0; t < tracks_.size(); ++t) {
    if (timestamp - tracks_[t].last_seen > options_.max_gap || views.empty()) continue;
    const auto expected = ExpectedBox(*views.front().camera, *tracks_[t].model,
                                      Expected(tracks_[t], T_odom_camera, tracks_[t].up_odom));
    if (!expected) continue;
    for (size_t v = 0; v < views.size(); ++v) {
      if (views[v].model != tracks_[t].model) continue;
      const auto agreement = BoxAgreement(*expected, views[v].detection.box, 0.25);
      if (agreement) all.push_back({*agreement, v, t});
    }
  }
  std::sort(all.begin(), all.end(), [](const Pair& a, const Pair& b) {
    return std::tuple(-a.agreement, a.view, a.track) < std::tuple(-b.agreement, b.view, b.track);
  });
  std::vector<bool> has_track(views.size(), false), is_taken(tracks_.size(), false);
  std::vector<Pair> pairs;
  for (const Pair& pair : all) {
    if (has_track[pair.view] || is_taken[pair.track]) continue;
    has_track[pair.view] = is_taken[pair.track] = true;
    pairs.push_back(pair);
  }
  return pairs;
}

std::vector<int> ObjectTracks::Associate(double timestamp, const std::vector<ObjectView>& views,
                                         const Eigen::Isometry3d& T_odom_camera) const {
  std::vector<int> ids(views.size(), kNoTrack);
  for (const Pair& pair : PairWithViews(timestamp, views, T_odom_camera))
    ids[pair.view] = tracks_[pair.track].id;
  return ids;
}

std::optional<double> ObjectTracks::Agreement(double timestamp, const std::vector<ObjectView>& views,
                                              const Eigen::Isometry3d& T_odom_camera) const {
  if (tracks_.empty() || views.empty()) return std::nullopt;
  double sum = 0;
  for (const Pair& pair : PairWithViews(timestamp, views, T_odom_camera)) sum += pair.agreement;
  return sum;
}

std::optional<TrackPrior> ObjectTracks::Predict(int id, const Eigen::Isometry3d& T_odom_camera,
                                                const Eigen::Vector3d& up_camera) const {
  const Track* found = FindTrack(id);
  if (found == nullptr || found->observations < kObservationsBeforeUse) return std::nullopt;
  const Track& track = *found;
  const Eigen::Matrix3d R_camera_odom = T_odom_camera.linear().transpose();
  const Eigen::Vector3d up_odom = T_odom_camera.linear() * up_camera;
  TrackPrior prior;
  prior.expected = Expected(track, T_odom_camera, up_odom);
  if (prior.expected.T_camera_object.translation().z() < 0.1) return std::nullopt;
  // Never too sure of it: floors keep a wrong prior correctable.
  const double position_sigma = kLeastRelativeSigma * prior.expected.T_camera_object.translation().norm();
  Eigen::MatrixXd covariance = InUnit(track.covariance, 1 / unit_.units_a_metre());
  covariance.diagonal().head<3>().array() += position_sigma * position_sigma;
  covariance(3, 3) += std::pow(kLeastYawSigmaDeg * kDegree, 2);
  covariance.diagonal().tail(track.model->modes()).array() += kLeastShapeSigma * kLeastShapeSigma;
  Eigen::MatrixXd to_camera = Eigen::MatrixXd::Identity(track.unknowns(), track.unknowns());
  to_camera.topLeftCorner<3, 3>() = R_camera_odom;
  covariance = to_camera * covariance * to_camera.transpose();
  // I = L L^T, and the residual is whitened by L^T.
  prior.information = covariance.inverse();
  prior.sqrt_information = prior.information.llt().matrixU();
  prior.belief = track.belief;
  const HorizontalAxes axes(up_odom);
  prior.yaw_zero = R_camera_odom * axes.zero;
  prior.yaw_quarter = R_camera_odom * axes.quarter;
  return prior;
}

int ObjectTracks::Update(int id, double timestamp, const ObjectView& view, const SingleViewResult& result,
                         const Eigen::Isometry3d& T_odom_camera) {
  const auto found = std::find_if(tracks_.begin(), tracks_.end(), [&](const Track& t) { return t.id == id; });
  Track& track = found == tracks_.end() ? AddTrack(*view.model) : *found;
  if (view.up_camera) track.up_odom = T_odom_camera.linear() * *view.up_camera;
  Accumulate(track, result, T_odom_camera);
  UpdateBelief(track, view, result, T_odom_camera);
  track.last_seen = timestamp;
  ++track.observations;
  return track.id;
}

void ObjectTracks::Accumulate(Track& track, const SingleViewResult& result,
                              const Eigen::Isometry3d& T_odom_camera) {
  const int n = track.unknowns(), B = n - 4;
  const Eigen::Matrix3d R = T_odom_camera.linear();
  const Eigen::Isometry3d& T = result.measured.estimate.T_camera_object;
  const Eigen::Vector3d t = T.translation(), ray = t.normalized();
  const bool known = track.observations >= kObservationsBeforeUse;

  // (rotation, translation, coefficients) in the camera -> (R t, yaw, coefficients) along the odometry's
  // axes.
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(n, 6 + B);
  G.block<3, 3>(0, 3) = R;
  G.block<1, 3>(3, 0) = (R.transpose() * track.up_odom).transpose();
  G.block(4, 6, B, B).setIdentity();
  Eigen::MatrixXd covariance =
      kMeasurementScale * kMeasurementScale * G * result.measured.covariance * G.transpose();
  // The expected distance, not the measured one: near errors would weigh more than far ones.
  const double distance =
      known ? Expected(track, T_odom_camera, track.up_odom).T_camera_object.translation().norm() : t.norm();
  const double depth_sigma = kDepthSigma * distance, lateral_sigma = kLateralSigma * distance;
  covariance.topLeftCorner<3, 3>() += depth_sigma * depth_sigma * R * ray * ray.transpose() * R.transpose();
  covariance.diagonal().head<3>().array() += lateral_sigma * lateral_sigma;
  covariance(3, 3) += std::pow(kYawSigmaDeg * kDegree, 2);
  covariance.diagonal().tail(B).array() += kTrackShapeSigma * kTrackShapeSigma;

  // [I, -R t] (z, u) = y; the position's rows are divided by u.
  const double yaw = HorizontalAxes(track.up_odom).ComputeYaw(R * T.linear().col(2));
  const double turned = AzimuthDifference(yaw, track.state(3), track.model->spec.symmetry_order);
  Eigen::VectorXd y(n);
  y << Eigen::Vector3d::Zero(), (known ? track.state(3) + turned : yaw),
      result.measured.estimate.coefficients;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n + 1);
  A.leftCols(n).setIdentity();
  A.block<3, 1>(0, n) = -R * t;
  double weight = 1;
  if (known) {
    const double units = unit_.units_a_metre();
    Eigen::VectorXd off = track.state - y;
    off.head<3>() -= T_odom_camera.translation() + units * R * t;
    const Eigen::MatrixXd in_units = InUnit(covariance, units);
    weight = 1 / (1 + off.dot((track.covariance + in_units).llt().solve(off)) / (2 * n));
    LearnUnit(track, T_odom_camera, t.norm(), R * ray,
              (R * ray).dot(in_units.topLeftCorner<3, 3>() * R * ray));
  }
  const Eigen::MatrixXd information = weight * covariance.inverse();
  // The category's shape statistics out of the measurement, inflated as it was; Solve puts them in once.
  Eigen::MatrixXd without_prior = information;
  without_prior.diagonal().tail(B).array() -=
      weight / (std::pow(kMeasurementScale, 2) / result.measured.shape_prior_information +
                std::pow(kTrackShapeSigma, 2));
  track.normal = kFading * track.normal + A.transpose() * without_prior * A;
  const Eigen::VectorXd by_camera = information.leftCols<3>() * T_odom_camera.translation();
  track.right_side = kFading * track.right_side + A.transpose() * information * y;
  track.of_cameras = kFading * track.of_cameras + A.transpose() * by_camera;
  track.camera_squares =
      kFading * track.camera_squares + by_camera.head<3>().dot(T_odom_camera.translation());
  track.camera_products = kFading * track.camera_products + by_camera.dot(y - A.col(n));
}

// log |t| = -log u + log |q(u) - c|: what the baseline triangulates against what the object's size says. The
// more of q itself rests on u (share f: all of it without a baseline), the less there is to learn.
void ObjectTracks::LearnUnit(const Track& track, const Eigen::Isometry3d& T_odom_camera, double distance,
                             const Eigen::Vector3d& ray_odom, double variance_along) {
  const Eigen::Vector3d to_object = track.state.head<3>() - T_odom_camera.translation();
  const double expected = to_object.dot(ray_odom);
  if (expected <= 0) return;
  const double f =
      std::clamp(track.by_units.head<3>().dot(ray_odom) * unit_.units_a_metre() / expected, 0.0, 1.0);
  const double expected_variance = ray_odom.dot(track.covariance.topLeftCorner<3, 3>() * ray_odom);
  const double variance = (variance_along + expected_variance) / (expected * expected);
  const double error = std::log(distance) + unit_.log_units() - std::log(expected);  // 0 if u is right
  unit_.Learn(error, 1 - f, variance);
}

void ObjectTracks::UpdateBelief(Track& track, const ObjectView& view, const SingleViewResult& result,
                                const Eigen::Isometry3d& T_odom_camera) const {
  if (!view.detection.azimuth) return;
  const Eigen::Isometry3d& T = result.estimate.T_camera_object;
  // Turning the estimate to the prior's azimuth gives the prior's front.
  const double azimuth = ViewpointFromRotation(T.linear(), T.translation()).azimuth;
  const Eigen::Matrix3d R = T_odom_camera.linear() * T.linear() *
                            Eigen::AngleAxisd(azimuth - *view.detection.azimuth, Eigen::Vector3d::UnitY());
  const double voted = HorizontalAxes(track.up_odom).ComputeYaw(R.col(2));
  double least = 1e9;
  for (int bin = 0; bin < YawBelief::kBins; ++bin) {
    const double yaw = (bin + 0.5) * 2 * M_PI / YawBelief::kBins - M_PI;
    const double off = AzimuthDifference(yaw, voted, track.model->spec.symmetry_order) / kVoteSigma;
    double& cost = track.belief.cost[static_cast<size_t>(bin)];
    cost = kFading * cost -
           kVoteWeight * std::log((1 - kVoteOutliers) * std::exp(-0.5 * off * off) + 0.1 * kVoteOutliers);
    least = std::min(least, cost);
  }
  for (double& cost : track.belief.cost) cost -= least;
}

// Half a turn back where the votes of all frames have come to favour it.
void ObjectTracks::TurnToBelief(Track& track) const {
  const double clearly = 2;
  if (track.belief.At(track.state(3)) < track.belief.At(track.state(3) + M_PI) + clearly) return;
  track.right_side += track.normal.col(3) * M_PI;  // normal * (z + pi e_yaw) = right side + normal * pi e_yaw
  track.state(3) += M_PI;
}

void ObjectTracks::SolveTrack(Track& track) const {
  const double u = unit_.units_a_metre();
  const int n = track.unknowns();
  const Eigen::LLT<Eigen::MatrixXd> factor = Factorised(track.normal.topLeftCorner(n, n));
  const Eigen::VectorXd by_unit = -factor.solve(track.normal.topRightCorner(n, 1));
  track.state = factor.solve(track.right_side.head(n) + track.of_cameras.head(n) / u) + by_unit;
  track.state.head<3>() *= u;
  track.by_units = by_unit / u;
  track.by_units.head<3>() *= u;
  track.covariance = InUnit(factor.solve(Eigen::MatrixXd::Identity(n, n)), u);
}

void ObjectTracks::Follow(double timestamp, const Eigen::Isometry3d& T_odom_camera) {
  unit_.Follow(timestamp, T_odom_camera);
  for (Track& track : tracks_) SolveTrack(track);
}

// Until objects have told the unit: metres a unit, s, by least squares over all tracks. In metres the
// equations are linear in s, too: z - s h = d. Noise shrinks what they give, but not by much.
void ObjectTracks::GuessUnit() {
  double information = 0, right_side = 0;
  for (const Track& track : tracks_) {
    const int n = track.unknowns();
    if (track.observations < kObservationsBeforeUse) continue;
    const Eigen::VectorXd H = track.of_cameras.head(n);
    const Eigen::VectorXd D = track.right_side.head(n) - track.normal.topRightCorner(n, 1);
    const Eigen::VectorXd by_z = Factorised(track.normal.topLeftCorner(n, n)).solve(H);
    information += track.camera_squares - H.dot(by_z);
    right_side += D.dot(by_z) - track.camera_products;
  }
  if (right_side * right_side < kLeastSigmasOfGuess * kLeastSigmasOfGuess * information || right_side <= 0)
    return;
  unit_.Guess(std::log(kCaution * information / right_side));
}

void ObjectTracks::Solve(double timestamp) {
  std::erase_if(tracks_, [&](const Track& track) { return timestamp - track.last_seen > options_.max_gap; });
  GuessUnit();
  unit_.Update();
  for (Track& track : tracks_) {
    SolveTrack(track);
    TurnToBelief(track);
  }
}

}  // namespace armature
