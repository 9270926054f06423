// SPDX-License-Identifier: BSD-3-Clause
// Where times were taken: machine, build, and what else kept the machine busy.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/build_info.h"

namespace armature {

struct BenchEnvironment {
  MachineInfo machine;
  BuildInfo build;
  int threads = 1;
  std::array<double, 3> load_average{};  // over 1, 5 and 15 minutes, before the first run
};

BenchEnvironment GetBenchEnvironment(int threads);

// Two lines: the machine; the build.
std::vector<std::string> EnvironmentLines(const BenchEnvironment& environment);

}  // namespace armature
