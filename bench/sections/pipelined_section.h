// SPDX-License-Identifier: BSD-3-Clause
// One thread against two: lines of the next frame found while this one's objects are estimated.
#pragma once

#include <string>
#include <vector>

#include "bench/bench_report.h"
#include "bench/sections/bench_task.h"

namespace armature {

inline const std::string kPipelinedTable = "pipelined";

// Whole runs of each lines engine over the sequence, in one thread and in two in turn; there has to be one.
// Throws InputError when a run would be no longer than the warm-up.
BenchSection PipelinedSection(const BenchTask& task);

// One run of a sequence after the warm-up.
struct PacedRun {
  std::string engine;
  bool pipelined = false;
  std::vector<double> latency_ms;  // a value a frame
  double frames_per_second = 0;
};

// A row an engine and mode: latencies of all runs together, the runs' median frames a second, and the ratio
// of that to the same engine's in one thread.
Table PipelinedTable(const std::vector<PacedRun>& runs);

}  // namespace armature
