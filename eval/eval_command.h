// SPDX-License-Identifier: BSD-3-Clause
// `armature eval`: runs against the truth of their sequences.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/configuration.h"
#include "eval/detections/eval_detections.h"
#include "eval/objects/eval_objects.h"
#include "eval/retrieval/eval_retrieval.h"
#include "eval/rooms/eval_rooms.h"
#include "eval/trajectories/eval_trajectories.h"
#include "eval/views/eval_observations.h"

namespace armature {

// The kinds of tables, in the order in which they are printed.
inline const std::vector<std::string> kTableNames{"observations",
                                                  "edges",
                                                  "trajectory",
                                                  "objects",
                                                  "each_object",
                                                  "normal",
                                                  "paper",
                                                  "retrieval",
                                                  "retrieval_variants",
                                                  "each_query",
                                                  kLibraryTableName,
                                                  "rooms",
                                                  "room_differences",
                                                  "error_budget",
                                                  "stability",
                                                  "worst_rooms",
                                                  "room_factors",
                                                  "room_groups",
                                                  kDetectionTableName};

struct EvalArguments {
  // Run folders or folders of such; or trajectory files alone; or, for the table of detections, sequence
  // folders; empty: of the library alone.
  std::vector<std::filesystem::path> runs;
  // Sequence folders with ground truth, or folders of such; empty: where each run says its sequence is. For
  // trajectory files: one trajectory file.
  std::vector<std::filesystem::path> ground_truth;
  std::vector<std::string> tables;   // of kTableNames; empty: all for which there are results and truth
  std::filesystem::path detections;  // file to judge in place of the sequence's own; empty: none
  std::string format = "text";
  bool json = false;
  std::filesystem::path out;  // folder for the tables and all raw rows, see eval_output.h; empty: none
  ObservationArguments observations;
  TrajectoryArguments trajectories;
  ObjectArguments objects;
  RetrievalTableArguments retrieval;
  RawRoomFiles raw_rooms{};              // of --out
  ConfigurationArguments configuration;  // its folder of category models
};

// The tables that are asked for, and their records, of finished runs; where none are named, all for which
// there are results and truth, maybe none. `format`: what they are written as, which decides on digits.
// Throws InputError.
Evaluation MakeRunTables(const EvalArguments& arguments, const std::vector<RunToEvaluate>& runs,
                         TableFormat format);

// Prints two tables of observations, one of edges where the truth has them, one of trajectories and three of
// objects a sequence, one of objects beside the paper's, and one of retrieval where a library is named.
// Without runs: that of the library alone; of sequence folders: those of detections. Returns the exit status;
// throws InputError.
int RunEval(EvalArguments arguments);

// Adds the sub-command; once it is parsed, its callback runs RunEval and stores the exit status.
void AddEvalCommand(CLI::App& app, int& exit_status);

}  // namespace armature
