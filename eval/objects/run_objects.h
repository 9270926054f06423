// SPDX-License-Identifier: BSD-3-Clause
// The maps of a run against the truth of its sequence.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/objects/object_evaluation.h"
#include "eval/views/run_evaluation.h"
#include "io/evaluation_records.h"
#include "io/run_configuration.h"
#include "io/run_results.h"

namespace armature {

struct ObjectEvaluationOptions {
  AlignmentKind alignment = AlignmentKind::kFirstPose;  // the map claims to be metric: no scale is given away
  int first_n = 10;                                     // pairs, of AlignmentKind::kFirstN
  double tolerance = 0.01;                              // seconds between the stamps of a pair, at most
  double gate_m = 1.0;                                  // furthest distance of a match, metres
};

// One of a run's two maps.
struct EvaluatedMap {
  Approach approach = Approach::kObjects;  // by odometry: objects_odometry.csv, moved as odometry_scaled.txt
  Similarity T_truth_run;                  // by which the map was brought to the truth
  std::vector<EvaluatedObject> by_distance;    // matched by MatchByDistance
  std::vector<EvaluatedObject> by_detections;  // by MatchByDetections; empty: observations name no objects

  bool is_by_odometry() const { return approach == Approach::kOdometryOnly; }
};

struct RunObjects {
  RunConfiguration configuration;
  std::vector<EvaluatedMap> maps;  // odometry's first; empty: the run has no objects.csv
};

// "odometry only", "objects, loop closure", "objects, no loop closure", "objects".
std::string ApproachTitle(Approach approach);

// Of a run's two maps.
Approach FindApproach(bool by_odometry, const RunConfiguration& configuration);

// objects.csv with trajectory.txt, and objects_odometry.csv with odometry_scaled.txt where it is there.
// Stamps of cameras match within kStampTolerance. Throws InputError: a malformed or missing file, no camera
// at a time of the truth, a true object's category without specification.
RunObjects EvaluateRunObjects(const RunResults& run, const SequenceTruth& sequence,
                              const std::vector<CategorySpec>& specs, const ObjectEvaluationOptions& options);

}  // namespace armature
