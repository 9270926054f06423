// SPDX-License-Identifier: BSD-3-Clause
// The single views in `armature eval`: their poses and their matches of edges and segments.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "eval/eval_inputs.h"
#include "eval/evaluation.h"

namespace armature {

struct ObservationArguments {
  std::filesystem::path cad;        // folder of annotated CAD models; empty: none
  std::filesystem::path raw;        // file of a row a detection; empty: none
  std::filesystem::path raw_edges;  // file of a row a match; empty: none
};

// The kinds of tables of single views, in the order in which they are printed.
inline const std::vector<std::string> kObservationTableNames{"observations", "edges"};

void AddObservationArguments(CLI::App& command, ObservationArguments& arguments);

// The named tables, a sequence after the other, and the records of all views. Matches are judged by
// edges_gt.csv of a sequence, else by the CAD models. `is_asked`: the table of edges is also of sequences
// without edges_gt.csv, which then need CAD models. Writes the raw rows. Throws InputError: a malformed or
// missing file, nothing to judge matches by, a file that cannot be written.
Evaluation MakeRunObservationTables(const std::vector<RunToEvaluate>& runs,
                                    const std::vector<CategoryModel>& models,
                                    const std::vector<std::string>& names, bool is_asked,
                                    const ObservationArguments& arguments);

}  // namespace armature
