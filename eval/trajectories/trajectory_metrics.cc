// SPDX-License-Identifier: BSD-3-Clause
#include "eval/trajectories/trajectory_metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/errors.h"
#include "base/statistics.h"
#include "base/text.h"
#include "geometry/rotation.h"
#include "truth/observation_metrics.h"

namespace armature {
namespace {

constexpr double kDeltaTolerance = 0.1;  // of delta

double AngleDegrees(const Eigen::Matrix3d& R) { return LogSO3(R).norm() / kDegree; }

// How far along each pair is: in seconds, in metres of the true path, or counted.
std::vector<double> Progress(const std::vector<PosePair>& pairs, DeltaUnit unit) {
  std::vector<double> progress;
  for (size_t i = 0; i < pairs.size(); ++i) {
    if (unit == DeltaUnit::kFrames) {
      progress.push_back(static_cast<double>(i));
    } else if (unit == DeltaUnit::kSeconds) {
      progress.push_back(pairs[i].timestamp - pairs[0].timestamp);
    } else {
      const Eigen::Vector3d& from = pairs[i == 0 ? 0 : i - 1].truth.translation();
      progress.push_back((i == 0 ? 0 : progress.back()) + (pairs[i].truth.translation() - from).norm());
    }
  }
  return progress;
}

// The later pair nearest to delta after pair i, if it is near enough.
std::optional<size_t> FindPartner(const std::vector<double>& progress, size_t i, const RelativeDelta& delta) {
  const double wanted = progress[i] + delta.value;
  const auto begin = progress.begin() + static_cast<std::ptrdiff_t>(i) + 1;
  auto nearest = std::lower_bound(begin, progress.end(), wanted);
  if (nearest == progress.end() || (nearest != begin && wanted - *(nearest - 1) < *nearest - wanted)) {
    if (nearest == begin) return std::nullopt;
    --nearest;
  }
  const double allowed = delta.unit == DeltaUnit::kFrames ? 0 : kDeltaTolerance * delta.value;
  if (std::abs(*nearest - wanted) > allowed + kStampRounding) return std::nullopt;
  return static_cast<size_t>(nearest - progress.begin());
}

RelativeError Compare(const std::vector<PosePair>& pairs, size_t first, size_t second, double scale) {
  const PosePair &i = pairs[first], &j = pairs[second];
  Eigen::Isometry3d motion = i.estimate.inverse() * j.estimate;
  motion.translation() *= scale;
  const Eigen::Isometry3d E = (i.truth.inverse() * j.truth).inverse() * motion;
  return {first, second, E.translation().norm(), AngleDegrees(E.linear())};
}

template <typename Error>
std::optional<ErrorStatistics> SummarizeField(const std::vector<Error>& errors, double Error::*field) {
  std::vector<double> values;
  values.reserve(errors.size());
  for (const Error& error : errors) values.push_back(error.*field);
  return SummarizeErrors(values);
}

}  // namespace

std::optional<ErrorStatistics> SummarizeErrors(const std::vector<double>& errors) {
  if (errors.empty()) return std::nullopt;
  const auto n = static_cast<double>(errors.size());
  ErrorStatistics s;
  s.count = errors.size();
  s.rmse = std::sqrt(std::inner_product(errors.begin(), errors.end(), errors.begin(), 0.0) / n);
  s.mean = std::accumulate(errors.begin(), errors.end(), 0.0) / n;
  s.median = Median(errors);
  const auto [min, max] = std::minmax_element(errors.begin(), errors.end());
  s.min = *min;
  s.max = *max;
  for (const double error : errors) s.std += (error - s.mean) * (error - s.mean) / n;
  s.std = std::sqrt(s.std);
  return s;
}

RelativeDelta RelativeDeltaFromText(const std::string& text) {
  const std::string units = "fsm";  // in the order of DeltaUnit
  const size_t unit = text.empty() ? std::string::npos : units.find(text.back());
  const std::string complaint = fmt::format("{} is no distance of poses", Quoted(text));
  const InputError error(complaint + "; write one like 10f (poses), 1s or 0.5m, greater than 0");
  if (unit == std::string::npos) throw error;
  const RelativeDelta delta{ParseNumber(text.substr(0, text.size() - 1), complaint),
                            static_cast<DeltaUnit>(unit)};
  const bool is_whole = delta.value == std::floor(delta.value);
  if (delta.value <= 0 || (delta.unit == DeltaUnit::kFrames && !is_whole)) throw error;
  return delta;
}

std::string RelativeDeltaName(const RelativeDelta& delta) {
  const char* units[] = {"frames", "s", "m"};
  return fmt::format("{:g} {}", delta.value, units[static_cast<size_t>(delta.unit)]);
}

std::vector<RelativeError> RelativeErrors(const std::vector<PosePair>& pairs, double scale,
                                          const RelativeDelta& delta) {
  const std::vector<double> progress = Progress(pairs, delta.unit);
  std::vector<RelativeError> errors;
  for (size_t i = 0; i < pairs.size(); ++i) {
    const std::optional<size_t> j = FindPartner(progress, i, delta);
    if (j) errors.push_back(Compare(pairs, i, *j, scale));
  }
  return errors;
}

TrajectoryEvaluation EvaluateTrajectory(const std::vector<TimedPose>& estimate,
                                        const std::vector<TimedPose>& truth,
                                        const TrajectoryOptions& options) {
  const std::vector<PosePair> pairs = PairPoses(estimate, truth, options.tolerance);
  TrajectoryEvaluation evaluation{.options = options, .estimated = estimate.size()};
  evaluation.alignment = Align(pairs, options.alignment, options.first_n);
  for (const PosePair& pair : pairs) {
    const Eigen::Isometry3d aligned = evaluation.alignment.Apply(pair.estimate);
    evaluation.poses.push_back({pair.timestamp, (aligned.translation() - pair.truth.translation()).norm(),
                                AngleDegrees(pair.truth.linear().transpose() * aligned.linear())});
  }
  evaluation.relative = RelativeErrors(pairs, evaluation.alignment.scale, options.delta);
  return evaluation;
}

std::optional<ErrorStatistics> AbsoluteError(const TrajectoryEvaluation& evaluation) {
  return SummarizeField(evaluation.poses, &PoseError::position);
}

std::optional<ErrorStatistics> RelativeTranslationError(const TrajectoryEvaluation& evaluation) {
  return SummarizeField(evaluation.relative, &RelativeError::translation);
}

std::optional<ErrorStatistics> RelativeRotationError(const TrajectoryEvaluation& evaluation) {
  return SummarizeField(evaluation.relative, &RelativeError::rotation_deg);
}

}  // namespace armature
