// SPDX-License-Identifier: BSD-3-Clause
// The work of a matrix as calls of this program.
#pragma once

#include <string>
#include <vector>

#include "app/reproduce/job.h"
#include "app/reproduce/job_planner.h"
#include "app/reproduce/matrix.h"

namespace armature {

// The evaluation of all runs, of which the matrix's own tables are made; none of rooms, which are too many
// for a table each.
inline constexpr const char* kAccuracyJob = "evaluation/accuracy";
// The same over rooms: those of a recipe, several sequences of one's own, or any that are repeated.
inline constexpr const char* kRoomsJob = "evaluation/rooms";

// Data, categories, library, runs ("runs/<variant>/<sequence>") and timings ("timings/<name>").
std::vector<Job> PlanRuns(const Matrix& matrix, const PlanFolders& folders);

// Of the runs and jobs that have succeeded: "evaluation/accuracy", "evaluation/rooms",
// "evaluation/retrieval", "evaluation/library"; each only where there is something to evaluate.
std::vector<Job> PlanEvaluation(const Matrix& matrix, const PlanFolders& folders,
                                const std::vector<JobRecord>& done);

struct ReportedFiles {
  std::vector<std::string> tables{};  // files of tables to be shown first
  std::vector<std::string> runs{};    // runs to be shown in pictures, where not all are
};

// The report of all that has succeeded.
Job PlanReport(const Matrix& matrix, const PlanFolders& folders, const std::vector<JobRecord>& done,
               const ReportedFiles& files);

}  // namespace armature
