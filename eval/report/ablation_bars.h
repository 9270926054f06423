// SPDX-License-Identifier: BSD-3-Clause
// What the normal term does, as bars.
#pragma once

#include <vector>

#include "eval/report/report_data.h"
#include "io/evaluation_records.h"

namespace armature {

// Of each sequence: mean pitch and roll of single observations and of the map's objects, a bar for the first
// run with each normal term. Nothing where all runs have the same one.
std::vector<AblationBars> NormalTermBars(const std::vector<UprightnessRecord>& records);

}  // namespace armature
