// SPDX-License-Identifier: BSD-3-Clause
#include "bench/environment.h"

#include <fmt/format.h>

#include <cstdlib>

namespace armature {

BenchEnvironment GetBenchEnvironment(int threads) {
  BenchEnvironment environment{GetMachineInfo(), GetBuildInfo(), threads, {}};
  if (getloadavg(environment.load_average.data(), 3) != 3) environment.load_average = {};
  return environment;
}

std::vector<std::string> EnvironmentLines(const BenchEnvironment& environment) {
  const auto& [machine, build, threads, load] = environment;
  return {fmt::format("{}, {} cores, {} thread{}; load average before {:.2f} {:.2f} {:.2f}", machine.cpu,
                      machine.cores, threads, threads == 1 ? "" : "s", load[0], load[1], load[2]),
          fmt::format("armature {} ({}{}), {}, {}; OpenCV {}, Eigen {}, Ceres {}", build.version,
                      build.git_commit, build.git_dirty ? ", modified" : "", build.compiler, build.flags,
                      build.opencv, build.eigen, build.ceres)};
}

}  // namespace armature
