// SPDX-License-Identifier: BSD-3-Clause
// The objects of the map in `armature eval`.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "eval/eval_inputs.h"
#include "eval/evaluation.h"
#include "eval/objects/run_objects.h"

namespace armature {

struct ObjectArguments {
  std::string alignment = "first_pose";  // one of AlignmentNames()
  double gate_m = 1.0;                   // furthest distance of a match, metres
  std::filesystem::path paper;  // the paper's numbers; empty: results/paper_object_errors.csv of the source
  std::filesystem::path raw;    // file of all rows; empty: none
  // As for trajectories.
  int first_n = 10;         // pairs that the alignment first_n looks at
  double tolerance = 0.01;  // seconds between the stamps of a pair
};

// The kinds of tables of objects, in the order in which they are printed.
inline const std::vector<std::string> kObjectTableNames{"objects", "each_object", "normal", "paper"};

// With the numbers checked. Throws InputError.
ObjectEvaluationOptions MakeObjectOptions(const ObjectArguments& arguments);

// --first-n and --tolerance are the trajectories'.
void AddObjectArguments(CLI::App& command, ObjectArguments& arguments);

// The named tables: a sequence after the other, then the paper's table of all; the records of all maps.
// `is_asked`: also of sequences
// none of whose runs has a map, without rows; otherwise they are left out, and a line on standard error says
// so. Writes the raw rows. Throws InputError: a bad argument, a malformed or missing file, a file that cannot
// be written.
Evaluation MakeRunObjectTables(const std::vector<RunToEvaluate>& runs,
                               const std::vector<CategoryModel>& models,
                               const std::vector<std::string>& names, bool is_asked,
                               const ObjectArguments& arguments);

}  // namespace armature
