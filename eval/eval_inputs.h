// SPDX-License-Identifier: BSD-3-Clause
// What `armature eval` is given: runs, and where the truth of each of them is.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/evaluation_records.h"
#include "io/run_results.h"

namespace armature {

struct RunToEvaluate {
  RunIdentity run;
  std::filesystem::path truth;     // sequence folder with its ground truth
  std::string name{};              // as shown; tells the runs of a sequence apart
  std::filesystem::path within{};  // the folder given that it is in; empty: it was given itself

  // Whether the truth has the file of this name, and so for the run.
  bool HasTruth(const std::string& file) const;
  bool HasResult(const std::string& file) const;
};

// What the runs on a sequence have in common: the folder, or the one that theirs are or were made from by
// `armature substitute`.
enum class RunsOfASequence { kOfOneFolder, kOfOneOrigin };

// The runs in or at the folders, in the order given. `truths`: sequence folders with ground truth
// (groundtruth.txt or objects_gt.csv), or folders of such; empty: where each run says that its sequence is.
// Throws InputError: no finished run, two truths of one name, a run of a sequence whose truth is not known,
// two runs of one sequence that have not that in common.
std::vector<RunToEvaluate> FindRuns(const std::vector<std::filesystem::path>& folders,
                                    const std::vector<std::filesystem::path>& truths,
                                    RunsOfASequence common = RunsOfASequence::kOfOneFolder);

// Short names of runs that tell them apart: the folder's name, that of the folder around it where the folder
// is named after the sequence, and the paths as they are where those are not distinct.
std::vector<std::string> RunNames(const std::vector<std::filesystem::path>& folders,
                                  const std::string& sequence);

std::vector<EvaluatedRunRecord> MakeRunRecords(const std::vector<RunToEvaluate>& runs);

}  // namespace armature
