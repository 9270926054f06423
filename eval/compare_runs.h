// SPDX-License-Identifier: BSD-3-Clause
// Runs of `armature compare`.
#pragma once

#include "eval/compare_command.h"

namespace armature {

// Sequence by sequence that both have a run of. Throws InputError: no sequence in common, two runs of one in
// A or B, the truth or models missing or malformed.
Comparison CompareRuns(const std::filesystem::path& a, const std::filesystem::path& b,
                       const CompareArguments& arguments);

}  // namespace armature
