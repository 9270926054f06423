// SPDX-License-Identifier: BSD-3-Clause
// Tables of how good a detector is.
#pragma once

#include <vector>

#include "io/evaluation_records.h"
#include "io/text_table.h"

namespace armature {

// What is found and how well; how long errors stay. Of one sequence.
std::vector<Table> DetectionTables(const std::vector<DetectionRecord>& records);

}  // namespace armature
