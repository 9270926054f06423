// SPDX-License-Identifier: BSD-3-Clause
// The numbers that people look for first, beside the paper's. A source that is missing leaves its figures
// out.
#pragma once

#include <vector>

#include "eval/report/report_data.h"
#include "eval/report/reported_bench.h"
#include "io/evaluation_records.h"

namespace armature {

// The average error of each sequence, of its first run with objects in the graph, matched as the table
// "paper" does. Beside our sequence seqN is the paper's N.
std::vector<HeadlineFigure> LocalizationFigures(const EvaluationRecords& records);

// Our total, the keypoint baseline's and their ratio, of the first sequence that engines were compared on.
std::vector<HeadlineFigure> TimingFigures(const ReportedBench& bench);

// Of the chairs of the first run that was retrieved for.
std::vector<HeadlineFigure> RetrievalFigures(const EvaluationRecords& records);

}  // namespace armature
