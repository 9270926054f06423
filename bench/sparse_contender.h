// SPDX-License-Identifier: BSD-3-Clause
// What is slow and remembers nothing takes part in a few frames only.
#pragma once

#include <functional>

#include "bench/harness.h"

namespace armature {

// Warm-up inputs, the last ones, that such a contender sees.
inline constexpr size_t kSparseWarmUp = 2;

// Lets the contender take part in about `count` of the used inputs after the warm-up, evenly spread.
void MakeSparse(Contender& contender, const std::function<bool(size_t input)>& is_used, size_t inputs,
                size_t warm_up, size_t count);

}  // namespace armature
