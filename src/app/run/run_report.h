// SPDX-License-Identifier: BSD-3-Clause
// What `armature run` prints when it is done.
#pragma once

#include <string>
#include <vector>

#include "app/run/sequence_run.h"

namespace armature {

// A row a sequence, then where the results are and what each file is.
std::string RunReportText(const std::vector<SequenceRunResult>& results);

// A list with an object a sequence: its name, the run's folder and the content of summary.json.
std::string RunReportJson(const std::vector<SequenceRunResult>& results);

}  // namespace armature
