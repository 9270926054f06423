// SPDX-License-Identifier: BSD-3-Clause
// One sequence through the pipeline, frame by frame, into a run folder. Memory does not grow with the images.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "io/run_summary.h"
#include "io/sequence.h"
#include "pipeline/options.h"

namespace armature {

struct SequenceRunSettings {
  Options options;
  std::vector<CategoryModel> models;
  std::string preset;           // for the summary
  std::string config_yaml;      // text of config.yaml
  bool overlays = false;        // also write overlays/<index>.jpg
  std::filesystem::path video;  // file of the overlays as a video; empty: none
  int frames = 0;               // only the first so many, 0: all
  int jitter = 0;               // seed of changes that must not matter, see jitter.h; 0: none
  bool pipelined = false;       // load the next image and find its lines in a second thread
};

struct SequenceRunResult {
  std::string sequence;          // its name
  std::filesystem::path folder;  // of the run
  std::filesystem::path video;   // empty: none
  RunCounts counts;
  StageStatistics statistics;
  FramePace pace;
  std::optional<MapSummary> map;  // none without odometry
};

// Throws InputError when the first image cannot be read; a later one is reported on standard error, skipped
// and counted. Throws Interrupted when the user stops it; in either case no folder is left behind.
SequenceRunResult RunSequence(const Sequence& sequence, const SequenceRunSettings& settings,
                              const std::filesystem::path& folder);

}  // namespace armature
