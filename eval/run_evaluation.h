// SPDX-License-Identifier: BSD-3-Clause
// A run against the truth of its sequence: one row a detection that is of a true object.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "eval/cad_library.h"
#include "eval/ground_truth.h"
#include "eval/observation_metrics.h"
#include "eval/run_results.h"
#include "eval/visible_edges.h"
#include "geometry/camera.h"

namespace armature {

constexpr double kLeastVisiblePixels = 20;  // an edge counts as visible from this visible length

// How near a match has to be to be right. Edges are annotated along the axes of legs and posts, whose
// outlines are some centimetres beside them: the second tolerance allows for that.
inline constexpr EdgeTolerance kOnEdge{.distance = 4, .metres = 0, .angle_deg = 6};
inline constexpr EdgeTolerance kNearEdge{.distance = 4, .metres = 0.05, .angle_deg = 6};

struct RightMatches {
  int matches =
      0;          // rows of associations.csv that lie on the edge they name, under the nearest symmetric turn
  int edges = 0;  // visible true edges with such a match
};

// Matches of one detection against its object's own edges.
struct MatchCounts {
  int matches = 0;         // rows of associations.csv
  int visible_edges = 0;   // true edges with at least kLeastVisiblePixels seen
  RightMatches on_edge;    // by kOnEdge
  RightMatches near_edge;  // by kNearEdge
};

struct EvaluatedDetection {
  double timestamp = 0;  // seconds
  int index = 0;
  std::string object;                     // id in objects_gt.csv
  std::string category;                   // the object's
  std::string status;                     // "ok", ...; "missing": the run has no row of it
  std::optional<ObservationError> error;  // none: the run gives no pose
  std::optional<MatchCounts> matches;     // none: the object's own edges are not known
};

struct RunEvaluation {
  std::string sequence;
  std::vector<EvaluatedDetection> detections;  // all detections with truth, by time
  int without_truth = 0;  // rows of the run that are of no true object, or at a stamp without true camera
};

// What is true of a sequence, as far as evaluation goes.
struct SequenceTruth {
  std::string name;
  Camera camera;
  GroundTruth truth;
};

// sequence.yaml and the ground truth of a sequence folder. Throws InputError.
SequenceTruth LoadSequenceTruth(const std::filesystem::path& folder);

// Throws InputError when an object's category has no specification or a match names an edge that it has not.
RunEvaluation EvaluateRun(const RunResults& run, const SequenceTruth& sequence,
                          const std::vector<CategorySpec>& specs, const CadLibrary& cad);

}  // namespace armature
