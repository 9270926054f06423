// SPDX-License-Identifier: BSD-3-Clause
// The retrieval of CAD models in `armature eval`.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "eval/eval_inputs.h"
#include "eval/evaluation.h"

namespace armature {

struct RetrievalTableArguments {
  std::filesystem::path library;  // file of instances; empty: none, and no tables
  // Of the library's own instances as queries.
  double noise = 0.3;      // standard deviations, on each coefficient
  int every = 10;          // each so many-th instance of a category
  std::uint64_t seed = 1;  // of the noise
};

// The kinds of tables of runs, in the order in which they are printed, and that of the library alone.
inline const std::vector<std::string> kRetrievalTableNames{"retrieval", "retrieval_variants", "each_query"};
inline constexpr const char* kLibraryTableName = "library";

void AddRetrievalTableArguments(CLI::App& command, RetrievalTableArguments& arguments);

// The named tables, each over all runs, and the records of the table retrieval. `cad`: folder of the true CAD
// models, also of those that the library does not have; empty: the library has them. Throws InputError: no
// library, one that is not of the models, runs without the files or the images that retrieval looks at.
Evaluation MakeRunRetrievalTables(const std::vector<RunToEvaluate>& runs,
                                  const std::vector<CategoryModel>& models,
                                  const std::vector<std::string>& names, const std::filesystem::path& cad,
                                  const RetrievalTableArguments& arguments);

// The library's instances as queries, without any run. Throws InputError: no library, one that is not of the
// models, a bad argument.
Table MakeLibraryTable(const std::vector<CategoryModel>& models, const RetrievalTableArguments& arguments);

}  // namespace armature
