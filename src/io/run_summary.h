// SPDX-License-Identifier: BSD-3-Clause
// summary.json of a run folder: what ran, on what, how much there was and how long it took.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "odometry/odometry.h"
#include "pipeline/frame_result.h"
#include "resection/object_estimate.h"

namespace armature {

// Keeps a number a stage and frame.
class StageStatistics {
 public:
  struct Stage {
    std::string name;
    std::vector<double> milliseconds;  // a value a frame
  };

  void Add(const StageTimes& times);
  // load, lines, association, optimization, mapping, total (without load)
  const std::array<Stage, 6>& stages() const { return stages_; }

 private:
  std::array<Stage, 6> stages_{{{"load", {}},
                                {"lines", {}},
                                {"association", {}},
                                {"optimization", {}},
                                {"mapping", {}},
                                {"total", {}}}};
};

// Every status, in the order of the enumeration.
inline constexpr std::array kAllStatuses{EstimateStatus::kOk,           EstimateStatus::kTooFewEdges,
                                         EstimateStatus::kBehindCamera, EstimateStatus::kDiverged,
                                         EstimateStatus::kOffTheBox,    EstimateStatus::kRepeated};

struct SkippedImage {
  double timestamp = 0;  // seconds
  std::string reason;    // one line
};

struct RunCounts {
  long frames = 0;  // processed, without the skipped
  long skipped_images = 0;
  long detections = 0;
  long segments = 0;
  std::array<long, kAllStatuses.size()> observations{};  // by status
  std::vector<SkippedImage> skipped;                     // the first hundred
};

// What became of the map.
struct MapSummary {
  long objects = 0;
  double scale = 1;                   // metres a unit of odometry, the mean over the sequence
  std::optional<double> scale_sigma;  // of its logarithm, as the graph has it: model errors come on top
  double first_scale = 1, last_scale = 1;
  double incremental_ms = 0;  // spent while frames came in, all of them
  double solve_ms = 0;        // of the batch solution at the end
};

// How fast frames came out, the writing of the run folder included.
struct FramePace {
  std::vector<double> latency_ms;  // from the loaded image to the frame's result, a value a processed frame
  double frames_per_second = 0;    // over all frames, loading them as well
};

// What the caller knows about the run.
struct RunSummary {
  std::string sequence;           // its name
  std::string sequence_folder{};  // absolute, empty: not known
  std::string detections{};       // absolute, their file; empty: the sequence's own
  int jitter = 0;                 // seed of what its input was changed by; 0: nothing
  std::string preset;             // configuration that the run started from
  int threads = 1;
  OdometryCoverage odometry{};      // of the whole sequence
  std::optional<MapSummary> map{};  // none without odometry
  FramePace pace{};
};

// Milliseconds a frame of the back end: both of the above, over the frames.
double BackEndMilliseconds(const RunCounts& counts, const MapSummary& map);

// The text of summary.json, with `"complete": true`.
std::string SummaryJson(const RunSummary& summary, const RunCounts& counts, const StageStatistics& statistics,
                        double wall_seconds);

}  // namespace armature
