// SPDX-License-Identifier: BSD-3-Clause
// The matrix as tables: a row a sequence and variant, whatever became of it.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/reproduce/job.h"
#include "app/reproduce/matrix.h"
#include "io/evaluation_records.h"
#include "io/text_table.h"

namespace armature {

// What the evaluation of the matrix's runs has left.
struct MatrixEvaluation {
  std::filesystem::path file;  // for messages
  EvaluationRecords records;
};

// Objects found and their errors, cameras' errors, single views, and why there is nothing where a job failed.
// `evaluation`: null: there is none. Throws InputError when it lacks a run that has succeeded.
Table MatrixTable(const Matrix& matrix, const std::vector<JobRecord>& jobs,
                  const MatrixEvaluation* evaluation);

// Mean and spread over the draws of each scene; none with one draw. As above.
std::optional<Table> DrawsTable(const Matrix& matrix, const std::vector<JobRecord>& jobs,
                                const MatrixEvaluation* evaluation);

// What was done: a row a job.
Table JobTable(const std::vector<JobRecord>& records);

}  // namespace armature
