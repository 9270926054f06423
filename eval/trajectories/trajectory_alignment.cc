// SPDX-License-Identifier: BSD-3-Clause
#include "eval/trajectories/trajectory_alignment.h"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

// Below these a trajectory does not move, or moves along a line only: what is left is rounding, of the files
// (their 9 digits behind the point) and of doubles far from the origin, as in UTM coordinates.
constexpr double kStill = 1e-8;      // units of the trajectory
constexpr double kRounding = 1e-14;  // of the distance from the origin
constexpr double kLine = 1e-10;      // second over first singular value: 1e-5 of the length across

constexpr double kLeastMotion_m = 0.05;  // of a camera whose path tells a scale

// First and second moments of the pairs' positions and rotations.
struct Moments {
  Eigen::Vector3d mean_estimate{0, 0, 0}, mean_truth{0, 0, 0};
  double variance_estimate = 0, variance_truth = 0;      // about the means
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // truth by estimate
  Eigen::Matrix3d rotations = Eigen::Matrix3d::Zero();   // sum of R_truth R_estimate^T
};

Moments ComputeMoments(const std::vector<PosePair>& pairs) {
  Moments m;
  const double share = 1.0 / static_cast<double>(pairs.size());
  for (const PosePair& pair : pairs) {
    m.mean_estimate += share * pair.estimate.translation();
    m.mean_truth += share * pair.truth.translation();
  }
  for (const PosePair& pair : pairs) {
    const Eigen::Vector3d x = pair.estimate.translation() - m.mean_estimate;
    const Eigen::Vector3d y = pair.truth.translation() - m.mean_truth;
    m.variance_estimate += share * x.squaredNorm();
    m.variance_truth += share * y.squaredNorm();
    m.covariance += share * y * x.transpose();
    m.rotations += pair.truth.linear() * pair.estimate.linear().transpose();
  }
  return m;
}

// `spread`: how far its positions are apart; `place`: one of them.
bool StaysInPlace(double spread, const Eigen::Vector3d& place) {
  return spread <= std::max(kStill, kRounding * place.norm());
}

// diag(1, 1, +-1) that makes U * signs * V^T a rotation and not a reflection.
Eigen::Vector3d Signs(const Eigen::JacobiSVD<Eigen::Matrix3d>& svd) {
  return {1, 1, svd.matrixU().determinant() * svd.matrixV().determinant() < 0 ? -1.0 : 1.0};
}

// The rotation R of largest tr(R^T A).
Eigen::Matrix3d NearestRotation(const Eigen::JacobiSVD<Eigen::Matrix3d>& svd) {
  return svd.matrixU() * Signs(svd).asDiagonal() * svd.matrixV().transpose();
}

Eigen::JacobiSVD<Eigen::Matrix3d> Decomposed(const Eigen::Matrix3d& A) {
  return Eigen::JacobiSVD<Eigen::Matrix3d>(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
}

// Of the rotations that take the direction `from` to `to`, the one of largest tr(R^T rotations).
// With A = rotations * R0^T, R0 one of them, and R = Rot(to, angle) * R0:
//   tr(R^T rotations) = cos(angle) (tr A - to^T A to) + sin(angle) to . (A32 - A23, A13 - A31, A21 - A12) +
//   c.
Eigen::Matrix3d RotationAboutLine(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                  const Eigen::Matrix3d& rotations) {
  const Eigen::Matrix3d R0 = SmallestRotation(from, to);
  const Eigen::Matrix3d A = rotations * R0.transpose();
  const Eigen::Vector3d twist(A(2, 1) - A(1, 2), A(0, 2) - A(2, 0), A(1, 0) - A(0, 1));
  const double angle = std::atan2(to.dot(twist), A.trace() - to.dot(A * to));
  return Eigen::AngleAxisd(angle, to).toRotationMatrix() * R0;
}

// Umeyama, "Least-squares estimation of transformation parameters between two point patterns", PAMI 1991,
// with the cameras' rotations deciding what the positions leave open.
Similarity LeastSquares(const std::vector<PosePair>& pairs, bool with_scale) {
  const Moments m = ComputeMoments(pairs);
  const auto svd = Decomposed(m.covariance);
  const Eigen::Vector3d& singular = svd.singularValues();
  const bool is_still = StaysInPlace(std::sqrt(m.variance_estimate), m.mean_estimate) ||
                        StaysInPlace(std::sqrt(m.variance_truth), m.mean_truth) || singular[0] <= 0;
  Similarity s;
  s.is_degenerate = is_still || singular[1] <= kLine * singular[0];
  if (is_still) {
    s.R = NearestRotation(Decomposed(m.rotations));
  } else if (s.is_degenerate) {
    s.R = RotationAboutLine(svd.matrixV().col(0), svd.matrixU().col(0), m.rotations);
  } else {
    s.R = NearestRotation(svd);
  }
  if (with_scale && !is_still) s.scale = singular.dot(Signs(svd)) / m.variance_estimate;
  s.t = m.mean_truth - s.scale * (s.R * m.mean_estimate);
  return s;
}

Similarity FirstPose(const PosePair& first, double scale) {
  Similarity s;
  s.scale = scale;
  s.R = first.truth.linear() * first.estimate.linear().transpose();
  s.t = first.truth.translation() - scale * (s.R * first.estimate.translation());
  return s;
}

Similarity EndPoints(const std::vector<PosePair>& pairs) {
  const auto distance = [&](Eigen::Isometry3d PosePair::*pose) {
    return ((pairs.back().*pose).translation() - (pairs.front().*pose).translation()).norm();
  };
  const double estimate = distance(&PosePair::estimate), truth = distance(&PosePair::truth);
  const bool is_closed = StaysInPlace(estimate, pairs.front().estimate.translation()) ||
                         StaysInPlace(truth, pairs.front().truth.translation());
  Similarity s = FirstPose(pairs.front(), is_closed ? 1 : truth / estimate);
  s.is_degenerate = is_closed;
  return s;
}

Similarity ScaleOnly(const std::vector<PosePair>& pairs) {
  const Similarity fit = LeastSquares(pairs, true);
  Similarity s = FirstPose(pairs.front(), fit.scale);
  s.is_degenerate = fit.is_degenerate;
  return s;
}

std::vector<PosePair> FirstPairs(const std::vector<PosePair>& pairs, int count) {
  const size_t kept = std::min(pairs.size(), static_cast<size_t>(std::max(count, 1)));
  return {pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(kept)};
}

}  // namespace

Eigen::Isometry3d Similarity::Apply(const Eigen::Isometry3d& T_world_x) const {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = R * T_world_x.linear();
  T.translation() = *this * T_world_x.translation();
  return T;
}

Similarity Align(const std::vector<PosePair>& pairs, AlignmentKind kind, int first_n) {
  if (kind == AlignmentKind::kNone) return {};
  if (pairs.empty()) return {.is_degenerate = true};
  switch (kind) {
    case AlignmentKind::kFirstPose:
      return FirstPose(pairs.front(), 1);
    case AlignmentKind::kSim3:
      return LeastSquares(pairs, true);
    case AlignmentKind::kScale:
      return ScaleOnly(pairs);
    case AlignmentKind::kEndPoints:
      return EndPoints(pairs);
    case AlignmentKind::kFirstN:
      return LeastSquares(FirstPairs(pairs, first_n), false);
    default:
      return LeastSquares(pairs, false);
  }
}

bool Moves(const std::vector<PosePair>& pairs) {
  return !pairs.empty() && std::sqrt(ComputeMoments(pairs).variance_truth) >= kLeastMotion_m;
}

std::optional<double> PathScale(const std::vector<PosePair>& pairs) {
  if (!Moves(pairs)) return std::nullopt;
  const Moments m = ComputeMoments(pairs);
  if (StaysInPlace(std::sqrt(m.variance_estimate), m.mean_estimate)) return std::nullopt;
  const double scale = LeastSquares(pairs, true).scale;
  return scale > 0 ? std::optional(scale) : std::nullopt;
}

}  // namespace armature
