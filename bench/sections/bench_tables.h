// SPDX-License-Identifier: BSD-3-Clause
// The tables by name.
#pragma once

#include <string>
#include <vector>

#include "bench/bench_report.h"
#include "bench/sections/bench_task.h"

namespace armature {

// "comparison", "objects", "detectors", "scaling", "pipelined", "memory", "micro",
// "retrieval"
const std::vector<std::string>& BenchTableNames();

// Measured in processes of their own, before sequences are loaded: see memory_section.h.
inline const std::string kMemoryTable = "memory";
// Of fixed inputs, without a sequence: see micro_benchmarks.h and retrieval_section.h.
inline const std::string kMicroTable = "micro";
inline const std::string kRetrievalTable = "retrieval";

// Whether it is of a sequence.
bool NeedsSequence(const std::string& table);

// Throws InputError for an unknown name.
void CheckBenchTableName(const std::string& name);

// Measures what the tables of that name are made of: one of the others.
BenchSection MeasureSection(const std::string& name, const BenchTask& task);

}  // namespace armature
