// SPDX-License-Identifier: BSD-3-Clause
// Peak memory of each engine, in a process of its own.
#pragma once

#include "bench/bench_report.h"
#include "bench/engines.h"
#include "bench/peak_memory.h"
#include "bench/sections/bench_task.h"
#include "io/sequence.h"

namespace armature {

// Frames that a process loads; more where the first object comes later.
inline constexpr size_t kMemoryFrames = 20;
// Frames with objects that a baseline, which remembers nothing, processes.
inline constexpr size_t kMemoryBaselineFrames = 2;

// `limit`: of the frames (0: none). Forks, so call it before anything big is loaded and any thread is
// started. Throws InputError as LoadBenchSequence.
BenchSection MemorySection(const Sequence& sequence, size_t limit, const EngineParts& parts,
                           const BenchSettings& settings);

struct NamedMemory {
  std::string engine;
  PeakMemory memory;
};

// A row a process; the first one has no engine.
Table MemoryTable(const std::vector<NamedMemory>& processes);

}  // namespace armature
