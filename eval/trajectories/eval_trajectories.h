// SPDX-License-Identifier: BSD-3-Clause
// The camera trajectories of `armature eval`: of runs, or of single files.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "eval/eval_inputs.h"
#include "eval/evaluation.h"

namespace armature {

struct TrajectoryArguments {
  std::vector<std::string> alignments{"first_pose", "se3", "sim3"};
  int first_n = 10;              // pairs that the alignment first_n looks at
  double tolerance = 0.01;       // seconds between the stamps of a pair
  std::string delta = "1s";      // of the relative error
  std::string format = "auto";   // of files
  std::filesystem::path stamps;  // of files in the KITTI format; empty: none
  double fps = 1;                // of files in the KITTI format without stamps
  double time_offset = 0;        // seconds added to the stamps of files
  std::filesystem::path raw;     // file of all rows; empty: none
};

void AddTrajectoryArguments(CLI::App& command, TrajectoryArguments& arguments);

// One table a sequence: trajectory.txt and odometry_scaled.txt of every run against groundtruth.txt. Throws
// InputError: a run has no trajectory, a sequence no truth of it, a file is malformed, an argument is bad.
// `failures` are of trajectories without a true pose at any stamp.
Evaluation MakeRunTrajectoryTables(const std::vector<RunToEvaluate>& runs,
                                   const TrajectoryArguments& arguments, TableFormat format);

// One table of all files against one truth: a trajectory file or a sequence folder. Throws InputError as
// above, and where KITTI files without stamps are not of equal length.
Evaluation MakeFileTrajectoryTables(const std::vector<std::filesystem::path>& files,
                                    const std::vector<std::filesystem::path>& truth,
                                    const TrajectoryArguments& arguments, TableFormat format);

}  // namespace armature
