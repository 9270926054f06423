// SPDX-License-Identifier: BSD-3-Clause
#include "eval/trajectories/trajectory_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/csv_fields.h"
#include "base/number_format.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

std::string AlignmentMeaning(AlignmentKind kind, int first_n) {
  switch (kind) {
    case AlignmentKind::kNone:
      return "as it is, nothing moved";
    case AlignmentKind::kFirstPose:
      return "moved rigidly so that the first matched pose is the true one";
    case AlignmentKind::kSe3:
      return "moved rigidly, least squares over all matched positions; the scale stays as estimated";
    case AlignmentKind::kSim3:
      return "moved and scaled, least squares over all matched positions: judges the shape, not the scale";
    case AlignmentKind::kScale:
      return "sim3's scale, then the first matched pose put on the true one";
    case AlignmentKind::kEndPoints:
      return "scale: true over estimated distance from the first to the last matched position; then the "
             "first pose put on the true one";
    case AlignmentKind::kFirstN:
      return fmt::format(
          "moved rigidly, least squares over the first {} matched positions: says little where the "
          "camera hardly moves in them",
          first_n);
  }
  return "";
}

// Nothing where a file is given by itself.
std::string TrajectoryText(TrajectoryKind kind) {
  return kind == TrajectoryKind::kFile ? "" : TrajectoryKindName(kind);
}

std::vector<Cell> MakeRow(const TrajectoryRecord& r, int digits) {
  std::vector<Cell> row{TextCell(r.run), TextCell(TrajectoryText(r.trajectory)),
                        TextCell(AlignmentName(r.alignment)), CountCell(r.matched_poses), CountCell(r.poses)};
  for (const auto& value :
       {r.alignment_scale, r.alignment_rotation_deg, r.alignment_translation_m, r.ate_rmse_m, r.ate_mean_m,
        r.ate_median_m, r.ate_max_m, r.rpe_rmse_m, r.rpe_rmse_deg})
    row.push_back(NumberCell(value, digits));
  row.push_back(CountCell(r.rpe_pairs));
  return row;
}

// What a reader has to know of single rows.
std::vector<std::string> Warnings(const std::vector<NamedTrajectory>& trajectories) {
  std::vector<std::string> warnings;
  std::set<std::string> unmatched;
  for (const NamedTrajectory& named : trajectories) {
    const TrajectoryEvaluation& e = named.evaluation;
    if (e.poses.empty()) {
      if (!named.IsUnmatched() || !unmatched.insert(TrajectoryLabel(named)).second) continue;
      warnings.push_back(fmt::format("{}: {}.", TrajectoryLabel(named), named.why_unmatched));
    } else if (e.alignment.is_degenerate) {
      warnings.push_back(
          fmt::format("{}: the positions do not determine {}: the cameras' rotations decide what they leave "
                      "open, a scale that they do not tell is 1.",
                      TrajectoryLabel(named), AlignmentName(e.options.alignment)));
    }
  }
  return warnings;
}

std::vector<std::string> Notes(const std::vector<NamedTrajectory>& trajectories) {
  std::vector<std::string> notes;
  if (trajectories.empty()) return notes;
  const TrajectoryOptions& first = trajectories.front().evaluation.options;
  notes = {
      fmt::format("matched of poses: estimated poses with a true one within {:g} ms, one to one, closest "
                  "first; all errors are of them.",
                  1e3 * first.tolerance),
      "alignment: how the estimate was brought to the truth, x_true = scale R x + t; "
      "scale, rotation (angle of R), translation (|t|) as found."};
  std::set<AlignmentKind> kinds;
  for (const NamedTrajectory& named : trajectories) {
    const TrajectoryOptions& options = named.evaluation.options;
    if (!kinds.insert(options.alignment).second) continue;
    notes.push_back(fmt::format("  {}: {}.", AlignmentName(options.alignment),
                                AlignmentMeaning(options.alignment, options.first_n)));
  }
  notes.push_back("ATE: distance of the aligned camera position from the true one.");
  notes.push_back(fmt::format("RPE: error of the motion over {}{}, from every pose that has a partner.",
                              RelativeDeltaName(first.delta),
                              first.delta.unit == DeltaUnit::kFrames ? "" : " (10 % more or less)"));
  for (std::string& warning : Warnings(trajectories)) notes.push_back(std::move(warning));
  return notes;
}

}  // namespace

std::string TrajectoryLabel(const NamedTrajectory& named) {
  const std::string trajectory = TrajectoryText(named.trajectory);
  return trajectory.empty() ? named.run : fmt::format("{}, {}", named.run, trajectory);
}

TrajectoryRecord MakeTrajectoryRecord(const std::string& sequence, const NamedTrajectory& named) {
  const TrajectoryEvaluation& e = named.evaluation;
  const auto ate = AbsoluteError(e), translation = RelativeTranslationError(e),
             rotation = RelativeRotationError(e);
  const auto known = [&](double value) { return e.poses.empty() ? std::nullopt : std::optional(value); };
  const auto field = [](const std::optional<ErrorStatistics>& s, double ErrorStatistics::*value) {
    return s ? std::optional((*s).*value) : std::nullopt;
  };
  return {.sequence = sequence,
          .run = named.run,
          .trajectory = named.trajectory,
          .alignment = e.options.alignment,
          .matched_poses = static_cast<long>(e.poses.size()),
          .poses = static_cast<long>(e.estimated),
          .alignment_scale = known(e.alignment.scale),
          .alignment_rotation_deg = known(LogSO3(e.alignment.R).norm() / kDegree),
          .alignment_translation_m = known(e.alignment.t.norm()),
          .ate_rmse_m = field(ate, &ErrorStatistics::rmse),
          .ate_mean_m = field(ate, &ErrorStatistics::mean),
          .ate_median_m = field(ate, &ErrorStatistics::median),
          .ate_max_m = field(ate, &ErrorStatistics::max),
          .rpe_rmse_m = field(translation, &ErrorStatistics::rmse),
          .rpe_rmse_deg = field(rotation, &ErrorStatistics::rmse),
          .rpe_pairs = static_cast<long>(e.relative.size())};
}

Table TrajectoryTable(const std::string& sequence, const std::vector<NamedTrajectory>& trajectories,
                      int digits) {
  Table table;
  table.title = sequence + ": camera trajectories";
  table.name = "trajectory";
  table.sequence = sequence;
  table.columns = {"run",          "trajectory",     "alignment",      "matched",
                   "poses",        "scale",          "rotation [deg]", "translation [m]",
                   "ATE rmse [m]", "ATE mean [m]",   "ATE median [m]", "ATE max [m]",
                   "RPE rmse [m]", "RPE rmse [deg]", "RPE pairs"};
  for (const NamedTrajectory& named : trajectories)
    table.rows.push_back(MakeRow(MakeTrajectoryRecord(sequence, named), digits));
  table.notes = Notes(trajectories);
  return table;
}

std::string RawTrajectoryHeader() {
  return "run,sequence,trajectory,alignment,scale,timestamp,position_error_m,rotation_error_deg,"
         "relative_to,relative_translation_m,relative_rotation_deg\n";
}

std::string RawTrajectoryRows(const std::string& sequence, const NamedTrajectory& trajectory) {
  const TrajectoryEvaluation& e = trajectory.evaluation;
  std::string rows;
  auto relative = e.relative.begin();
  for (size_t i = 0; i < e.poses.size(); ++i) {
    const PoseError& pose = e.poses[i];
    rows += fmt::format("{},{},{},{},{},{},{},{}", CsvField(trajectory.run), CsvField(sequence),
                        TrajectoryText(trajectory.trajectory), AlignmentName(e.options.alignment),
                        Fixed(e.alignment.scale, 12), Fixed(pose.timestamp, 6), Fixed(pose.position, 9),
                        Fixed(pose.rotation_deg, 6));
    if (relative != e.relative.end() && relative->first == i) {
      rows += fmt::format(",{},{},{}\n", Fixed(e.poses[relative->second].timestamp, 6),
                          Fixed(relative->translation, 9), Fixed(relative->rotation_deg, 6));
      ++relative;
    } else {
      rows += ",,,\n";
    }
  }
  return rows;
}

}  // namespace armature
