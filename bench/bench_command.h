// SPDX-License-Identifier: BSD-3-Clause
// `armature bench`: how long the parts take, next to what they find.
#pragma once

#include <CLI/CLI.hpp>

#include "bench/bench_arguments.h"

namespace armature {

// Reads and checks everything before the first clock starts, then prints the tables. Returns the exit status:
// 1 when something became slower than the reference. Throws InputError.
int RunBench(BenchArguments arguments);

// Adds the sub-command; once it is parsed, its callback runs RunBench and stores the exit status.
void AddBenchCommand(CLI::App& app, int& exit_status);

}  // namespace armature
