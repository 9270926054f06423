// SPDX-License-Identifier: BSD-3-Clause
// Benchmarks of `armature compare`.
#pragma once

#include "cli/comparison.h"

namespace armature {

// bench.json as the guard compares them, and raw.csv pass by pass. Throws InputError: no span in common, a
// malformed file.
Comparison CompareBenches(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace armature
