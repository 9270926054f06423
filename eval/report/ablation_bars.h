// SPDX-License-Identifier: BSD-3-Clause
// What the normal term does, as bars.
#pragma once

#include <vector>

#include "eval/report/report_data.h"

namespace armature {

// From each table "normal": mean pitch and roll of single observations and of the map's objects, a bar for
// the first run with each normal term. Nothing where all runs have the same one.
std::vector<AblationBars> NormalTermBars(const std::vector<Table>& tables);

}  // namespace armature
