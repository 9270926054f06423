// SPDX-License-Identifier: BSD-3-Clause
// The tables of camera trajectories of `armature eval`.
#pragma once

#include <string>
#include <vector>

#include "eval/trajectories/trajectory_metrics.h"
#include "io/text_table.h"

namespace armature {

struct NamedTrajectory {
  std::string run;  // as shown
  TrajectoryKind trajectory = TrajectoryKind::kFile;
  TrajectoryEvaluation evaluation;
  std::string why_unmatched{};  // one line, where it has poses and none has a true one

  bool IsUnmatched() const { return evaluation.estimated > 0 && evaluation.poses.empty(); }
};

// "run, trajectory"; of a file its name alone.
std::string TrajectoryLabel(const NamedTrajectory& trajectory);

TrajectoryRecord MakeTrajectoryRecord(const std::string& sequence, const NamedTrajectory& trajectory);

// Trajectories against one truth, a row each, in the order given. `digits`: after the point of metres,
// degrees and scales. Nothing matched: dashes.
Table TrajectoryTable(const std::string& sequence, const std::vector<NamedTrajectory>& trajectories,
                      int digits);

// The names of the columns of the rows below.
std::string RawTrajectoryHeader();
// A row a matched pose: its absolute error, and the relative error of the motion that begins at it (empty: it
// has no partner).
std::string RawTrajectoryRows(const std::string& sequence, const NamedTrajectory& trajectory);

}  // namespace armature
