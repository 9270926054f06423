// SPDX-License-Identifier: BSD-3-Clause
// The tables by name.
#pragma once

#include <string>
#include <vector>

#include "bench/bench_report.h"
#include "bench/sections/bench_task.h"

namespace armature {

// "comparison", "objects", "detectors", "scaling"
const std::vector<std::string>& BenchTableNames();

// Throws InputError for an unknown name.
void CheckBenchTableName(const std::string& name);

// Measures what the tables of that name are made of. The name has to be known.
BenchSection MeasureSection(const std::string& name, const BenchTask& task);

}  // namespace armature
