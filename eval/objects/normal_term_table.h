// SPDX-License-Identifier: BSD-3-Clause
// What the normal term does (the paper's section 4.3): pitch and roll of objects with and without it.
#pragma once

#include <vector>

#include "eval/objects/object_tables.h"
#include "eval/views/evaluation_tables.h"
#include "io/text_table.h"

namespace armature {

// A record a run, in their order. Throws as below.
std::vector<UprightnessRecord> MakeUprightnessRecords(const SequenceObjects& sequence,
                                                      const std::vector<NamedEvaluation>& evaluations);

// A row a run: absolute pitch and roll of the map's found objects, and of the single observations with status
// ok. `evaluations`: the same runs in the same order. Throws std::invalid_argument when their numbers
// differ.
Table NormalTermTable(const SequenceObjects& sequence, const std::vector<NamedEvaluation>& evaluations);

}  // namespace armature
