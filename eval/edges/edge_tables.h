// SPDX-License-Identifier: BSD-3-Clause
// The table of edge matches that `armature eval` prints.
#pragma once

#include <string>
#include <vector>

#include "eval/views/evaluation_tables.h"
#include "io/text_table.h"

namespace armature {

// Runs on one sequence, a row a run and category and one of all categories.
Table EdgeTable(const std::string& sequence, const std::vector<NamedEvaluation>& runs);

// A row a match of a detection with truth and pose whose object's own edges are known; CSV. Empty field: the
// true edge is outside the image.
std::string RawEdgesCsv(const std::vector<NamedEvaluation>& runs);

}  // namespace armature
