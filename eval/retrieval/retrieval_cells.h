// SPDX-License-Identifier: BSD-3-Clause
// What the tables of retrieval have in common: columns, and the lines that define them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/retrieval/retrieval_summary.h"
#include "io/text_table.h"

namespace armature {

Cell Centimetres(const std::optional<double>& metres);

// queries, in library, top-1 [%], top-5 [%], MRR
void PushRanks(const RetrievalSummary& summary, std::vector<Cell>& row);
// compared, Chamfer [cm], best of 5, by true shape, ratio
void PushDistances(const RetrievalSummary& summary, std::vector<Cell>& row);

std::vector<std::string> RankNotes();
std::vector<std::string> DistanceNotes();

void AppendNotes(const std::vector<std::string>& notes, Table& table);

}  // namespace armature
