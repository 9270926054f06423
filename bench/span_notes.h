// SPDX-License-Identifier: BSD-3-Clause
// The lines under a table of times that say what each span is.
#pragma once

#include <string>
#include <vector>

#include "bench/sections/bench_task.h"

namespace armature {

// How times are taken: clock, threads, turns, warm-up.
std::string ClockNote(const BenchSettings& settings);

// The stages and the total.
std::vector<std::string> StageNotes();

// A line an engine: what it is.
std::vector<std::string> EngineNotes(const std::vector<std::string>& names, const EngineParts& parts);

}  // namespace armature
