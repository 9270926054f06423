// SPDX-License-Identifier: BSD-3-Clause
// A run against the truth of its sequence: one row a detection that is of a true object.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "eval/edges/edge_matches.h"
#include "io/run_results.h"
#include "truth/cad_library.h"
#include "truth/observation_metrics.h"
#include "truth/sequence_truth.h"

namespace armature {

struct EvaluatedDetection {
  double timestamp = 0;  // seconds
  int index = 0;
  std::string object;                     // id in objects_gt.csv
  std::string category;                   // the object's
  std::string status;                     // "ok", ...; "missing": the run has no row of it
  std::optional<ObservationError> error;  // none: the run gives no pose
  std::optional<MatchCounts> matches;     // none: the object's own edges are not known
  std::vector<JudgedMatch> judged;        // each of them
};

struct RunEvaluation {
  std::string sequence;
  std::vector<EvaluatedDetection> detections;  // all detections with truth, by time
  int without_truth = 0;  // rows of the run that are of no true object, or at a stamp without true camera
  int false_alarms = 0;   // detections that are of no object, by the truth
  int trusted_false_alarms = 0;  // those of them to which the run gives a pose with status ok
  bool has_true_edges = false;   // matches are judged by edges_gt.csv; else by CAD models, if at all
};

// Throws InputError when an object's category has no model or a match names an edge that it has not.
RunEvaluation EvaluateRun(const RunResults& run, const SequenceTruth& sequence,
                          const std::vector<CategoryModel>& models, const CadLibrary& cad);

}  // namespace armature
