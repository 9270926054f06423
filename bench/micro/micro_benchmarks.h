// SPDX-License-Identifier: BSD-3-Clause
// All micro-benchmarks by name, taking turns, and what is said about their times.
#pragma once

#include "bench/bench_report.h"
#include "bench/micro/micro_benchmark.h"
#include "io/named_span.h"
#include "io/text_table.h"

namespace armature {

// Runs of each that count, and before those that do not.
inline constexpr size_t kMicroRuns = 40;
inline constexpr size_t kMicroWarmUp = 3;

BenchSection MicroSection(const std::vector<MicroBenchmark>& benchmarks);

std::vector<MicroBenchmark> MicroBenchmarks(const MicroSetup& setup);

// Those of the given names ("hypothesis:chair") or families ("hypothesis"), each once, in their order; all
// for no name. Throws InputError for an unknown name.
std::vector<MicroBenchmark> ChosenMicroBenchmarks(std::vector<MicroBenchmark> all,
                                                  const std::vector<std::string>& names);

// Table "micro", no sequence, stage "call": a span for each benchmark that has rows, in their order.
std::vector<NamedSpan> MicroSpans(const std::vector<MicroBenchmark>& benchmarks,
                                  const std::vector<BenchRow>& rows);

// Microseconds a call; below, what a call is. A benchmark without a span shows dashes.
Table MicroTable(const std::vector<MicroBenchmark>& benchmarks, const std::vector<NamedSpan>& spans);

}  // namespace armature
