// SPDX-License-Identifier: BSD-3-Clause
// Time against hypotheses, segments and image size.
#pragma once

#include "bench/bench_report.h"
#include "bench/sections/bench_task.h"

namespace armature {

// Frames that are used, at most: those of the largest image size are in memory at once.
inline constexpr size_t kMostScalingFrames = 100;

// Our pipeline in the variants of bench/sections/load_variants.h, all on the same frames in turn.
BenchSection ScalingSection(const BenchTask& task);

}  // namespace armature
