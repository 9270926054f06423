// SPDX-License-Identifier: BSD-3-Clause
// The work of a matrix as calls of this program.
#pragma once

#include <string>
#include <vector>

#include "app/reproduce/job.h"
#include "app/reproduce/job_planner.h"
#include "app/reproduce/matrix.h"

namespace armature {

// The evaluation of all runs, of which the matrix's own tables are made.
inline constexpr const char* kAccuracyJob = "evaluation/accuracy";

// Data, categories, library, runs ("runs/<variant>/<sequence>") and timings ("timings/<name>").
std::vector<Job> PlanRuns(const Matrix& matrix, const PlanFolders& folders);

// Of the runs and jobs that have succeeded: "evaluation/accuracy", "evaluation/retrieval",
// "evaluation/library"; each only where there is something to evaluate.
std::vector<Job> PlanEvaluation(const Matrix& matrix, const PlanFolders& folders,
                                const std::vector<JobRecord>& done);

// The report of all that has succeeded; `tables`: files of tables to be shown first.
Job PlanReport(const Matrix& matrix, const PlanFolders& folders, const std::vector<JobRecord>& done,
               const std::vector<std::string>& tables);

}  // namespace armature
