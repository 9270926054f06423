// SPDX-License-Identifier: BSD-3-Clause
// The tables of single views that `armature eval` prints.
#pragma once

#include <string>
#include <vector>

#include "eval/views/run_evaluation.h"
#include "io/evaluation_records.h"
#include "io/text_table.h"

namespace armature {

struct NamedEvaluation {
  std::string run;  // as shown
  RunEvaluation evaluation;
};

// A record a run, category and choice of estimates: all of them, then those with status ok.
std::vector<ViewRecord> MakeViewRecords(const std::string& sequence,
                                        const std::vector<NamedEvaluation>& runs);

// What detections of the runs are of, sorted.
std::vector<std::string> ListCategories(const std::vector<NamedEvaluation>& runs);

// Whether the matches of the runs, on one sequence, are judged by its edges_gt.csv.
bool HaveTrueEdges(const std::vector<NamedEvaluation>& runs);

// Runs on one sequence, a row a run and category and one of all categories: first of all detections that have
// an estimate whatever its status, then of those with status ok alone.
std::vector<Table> EvaluationTables(const std::string& sequence, const std::vector<NamedEvaluation>& runs);

// A row a run and detection with truth; CSV. Empty fields: not known.
std::string RawCsv(const std::vector<NamedEvaluation>& runs);

}  // namespace armature
