// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sections/micro_section.h"

#include "bench/micro/micro_benchmarks.h"
#include "bench/sections/calibrated_race.h"

namespace armature {

BenchSection MicroSection(const std::vector<MicroBenchmark>& benchmarks) {
  BenchSection section{.name = "micro", .sequence = ""};
  std::vector<Contender> contenders;
  contenders.reserve(benchmarks.size());
  for (const MicroBenchmark& benchmark : benchmarks) contenders.push_back(benchmark.make());
  RaceCalibrated(std::move(contenders), kMicroRuns + kMicroWarmUp, {kMicroWarmUp, 1}, section);
  section.spans = MicroSpans(benchmarks, section.rows);
  section.tables = {MicroTable(benchmarks, section.spans)};
  return section;
}

}  // namespace armature
