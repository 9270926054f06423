// SPDX-License-Identifier: BSD-3-Clause
// What is slow and remembers nothing takes part in a few frames only.
#pragma once

#include <functional>
#include <vector>

#include "bench/harness.h"

namespace armature {

// Warm-up inputs, the last ones, that such a contender sees.
inline constexpr size_t kSparseWarmUp = 2;

// The inputs in which it takes part, growing: those of the warm-up, and then about `count` of the used ones,
// evenly spread.
std::vector<size_t> SparseInputs(const std::function<bool(size_t input)>& is_used, size_t inputs,
                                 size_t warm_up, size_t count);

// Whether an input is one of those: what a contender wants.
std::function<bool(size_t input)> PickOne(std::vector<size_t> inputs);

}  // namespace armature
