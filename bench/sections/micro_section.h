// SPDX-License-Identifier: BSD-3-Clause
// Micro-benchmarks, taking turns.
#pragma once

#include "bench/bench_report.h"
#include "bench/micro/micro_benchmark.h"

namespace armature {

// Runs of each that count, and before those that do not.
inline constexpr size_t kMicroRuns = 40;
inline constexpr size_t kMicroWarmUp = 3;

BenchSection MicroSection(const std::vector<MicroBenchmark>& benchmarks);

}  // namespace armature
