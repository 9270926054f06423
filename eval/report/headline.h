// SPDX-License-Identifier: BSD-3-Clause
// The numbers that people look for first, beside the paper's. A source that is missing leaves its figures
// out.
#pragma once

#include <vector>

#include "eval/report/bench_results.h"
#include "eval/report/report_data.h"

namespace armature {

// The average error of each sequence, of its first run with objects in the graph, from the table "paper".
// Beside our sequence seqN is the paper's N.
std::vector<HeadlineFigure> LocalizationFigures(const std::vector<Table>& tables);

// Our total, the keypoint baseline's and their ratio, of the first sequence that engines were compared on.
std::vector<HeadlineFigure> TimingFigures(const BenchResults& bench);

// Of the chairs of the first run in the table "retrieval".
std::vector<HeadlineFigure> RetrievalFigures(const std::vector<Table>& tables);

}  // namespace armature
