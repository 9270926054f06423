// SPDX-License-Identifier: BSD-3-Clause
#include "bench/harness.h"

#include <fmt/format.h>

#include "io/errors.h"
#include "pipeline/stage_clock.h"

namespace armature {
namespace {

BenchRow Run(const Contender& contender, size_t repetition, size_t input) {
  BenchRow row{.contender = contender.name, .repetition = repetition, .input = input, .outcome = {}};
  {
    const StageClock clock(row.wall_ms);
    row.outcome = contender.run(input);
  }
  row.wall_ms /= contender.calls;
  return row;
}

}  // namespace

Contender ContenderOf(const std::string& name, Engine& engine, const BenchSequence& sequence) {
  return {.name = name,
          .start = [&engine, &sequence] { engine.Start(sequence); },
          .run = [&engine, &sequence](size_t input) { return engine.Process(sequence.frames[input]); }};
}

std::vector<BenchRow> Race(const std::vector<Contender>& contenders, size_t inputs,
                           const HarnessOptions& options) {
  if (inputs <= options.warm_up) {
    throw InputError(
        fmt::format("{} frames are no more than the warm-up of {}: nothing is left to measure; "
                    "take more frames or a shorter --warm-up",
                    inputs, options.warm_up));
  }
  std::vector<BenchRow> rows;
  for (size_t repetition = 0; repetition < options.repetitions; ++repetition) {
    for (const Contender& contender : contenders) {
      if (contender.start) contender.start();
    }
    for (size_t input = 0; input < inputs; ++input) {
      for (size_t turn = 0; turn < contenders.size(); ++turn) {
        const Contender& contender = contenders[(input + turn) % contenders.size()];
        // Warm-up is of every contender, however seldom it takes part.
        if (input >= options.warm_up && (input - options.warm_up) % contender.every != 0) continue;
        BenchRow row = Run(contender, repetition, input);
        if (input >= options.warm_up) rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

}  // namespace armature
