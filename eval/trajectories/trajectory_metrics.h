// SPDX-License-Identifier: BSD-3-Clause
// How far an estimated camera trajectory is from the true one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "eval/trajectories/trajectory_alignment.h"

namespace armature {

struct ErrorStatistics {
  size_t count = 0;
  double rmse = 0, mean = 0, median = 0, max = 0, min = 0;
  double std = 0;  // about the mean, over the count
};

// None of no errors.
std::optional<ErrorStatistics> SummarizeErrors(const std::vector<double>& errors);

// How far apart the two poses of a relative error are.
enum class DeltaUnit { kFrames, kSeconds, kMetres };
struct RelativeDelta {
  double value = 1;
  DeltaUnit unit = DeltaUnit::kSeconds;
};

// "10f" (pairs of poses, a whole number), "1s" or "0.5m"; throws InputError for anything else.
RelativeDelta RelativeDeltaFromText(const std::string& text);
// "10 frames", "1 s", "0.5 m".
std::string RelativeDeltaName(const RelativeDelta& delta);

// Of the motion from one pose to a later one: E = (T_true_i^-1 T_true_j)^-1 (T_i^-1 T_j), the estimate's
// lengths times the alignment's scale. Its rotation and translation have no part in it.
struct RelativeError {
  size_t first = 0, second = 0;  // i and j among the pairs
  double translation = 0;        // |translation of E|, metres
  double rotation_deg = 0;       // angle of E's rotation, degrees
};

// From every pose to the later one whose distance is nearest to delta (seconds, or metres along the true
// path), left out where that is more than a tenth of delta off; with frames exactly so many pairs later.
std::vector<RelativeError> RelativeErrors(const std::vector<PosePair>& pairs, double scale,
                                          const RelativeDelta& delta);

struct TrajectoryOptions {
  AlignmentKind alignment = AlignmentKind::kSe3;
  int first_n = 10;         // pairs that first_n is aligned by
  double tolerance = 0.01;  // seconds between the stamps of a pair, at most
  RelativeDelta delta{};
};

// The absolute error of one aligned pose.
struct PoseError {
  double timestamp = 0;     // seconds, the estimate's
  double position = 0;      // metres
  double rotation_deg = 0;  // angle between the aligned and the true rotation
};

struct TrajectoryEvaluation {
  TrajectoryOptions options;
  size_t estimated = 0;  // poses of the estimate
  Similarity alignment{};
  std::vector<PoseError> poses{};         // a pair, by growing stamps
  std::vector<RelativeError> relative{};  // indices into `poses`
};

// Both by growing stamps; nothing matched gives no errors.
TrajectoryEvaluation EvaluateTrajectory(const std::vector<TimedPose>& estimate,
                                        const std::vector<TimedPose>& truth,
                                        const TrajectoryOptions& options);

// The absolute trajectory error (ATE): of the positions, metres. The relative (RPE): translation in metres,
// rotation in degrees.
std::optional<ErrorStatistics> AbsoluteError(const TrajectoryEvaluation& evaluation);
std::optional<ErrorStatistics> RelativeTranslationError(const TrajectoryEvaluation& evaluation);
std::optional<ErrorStatistics> RelativeRotationError(const TrajectoryEvaluation& evaluation);

}  // namespace armature
