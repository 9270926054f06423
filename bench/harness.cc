// SPDX-License-Identifier: BSD-3-Clause
#include "bench/harness.h"

#include <fmt/format.h>

#include "base/errors.h"
#include "base/interrupt.h"
#include "base/stage_clock.h"

namespace armature {
namespace {

BenchRow Run(const Contender& contender, size_t repetition, size_t input) {
  if (contender.before) contender.before();
  BenchRow row{.contender = contender.name, .repetition = repetition, .input = input, .outcome = {}};
  {
    const StageClock clock(row.wall_ms);
    row.outcome = contender.run(input);
  }
  row.wall_ms /= contender.calls;
  return row;
}

// A contender in one repetition.
struct Starter {
  const Contender* contender;
  size_t wanted = 0;  // inputs after the warm-up that it wanted so far

  bool TakesPart(size_t input, bool warming_up) {
    if (contender->wants && !contender->wants(input)) return false;
    // Warm-up is of every contender, however seldom it takes part.
    return warming_up || wanted++ % contender->every == 0;
  }
};

void RaceOnce(const std::vector<Contender>& contenders, size_t inputs, size_t warm_up, size_t repetition,
              std::vector<BenchRow>& rows) {
  std::vector<Starter> starters;
  for (const Contender& contender : contenders) {
    if (contender.start) contender.start();
    starters.push_back({&contender});
  }
  for (size_t input = 0; input < inputs; ++input) {
    for (size_t turn = 0; turn < starters.size(); ++turn) {
      Starter& starter = starters[(input + turn) % starters.size()];
      if (!starter.TakesPart(input, input < warm_up)) continue;
      ThrowIfInterrupted();
      BenchRow row = Run(*starter.contender, repetition, input);
      if (input < warm_up) continue;
      if (starter.contender->after) starter.contender->after(row);
      rows.push_back(std::move(row));
    }
  }
}

}  // namespace

Contender MakeContender(const std::string& name, Engine& engine, const BenchSequence& sequence) {
  return {.name = name,
          .start = [&engine, &sequence] { engine.Start(sequence); },
          .run = [&engine, &sequence](size_t input) { return engine.Process(sequence.frames[input]); }};
}

void CheckLongerThanWarmUp(size_t inputs, const HarnessOptions& options) {
  if (inputs > options.warm_up) return;
  throw InputError(
      fmt::format("{} frames are no more than the warm-up of {}: nothing is left to measure; "
                  "take more frames or a shorter --warm-up",
                  inputs, options.warm_up));
}

std::vector<BenchRow> RunInterleaved(const std::vector<Contender>& contenders, size_t inputs,
                                     const HarnessOptions& options) {
  CheckLongerThanWarmUp(inputs, options);
  std::vector<BenchRow> rows;
  for (size_t repetition = 0; repetition < options.repetitions; ++repetition) {
    RaceOnce(contenders, inputs, options.warm_up, repetition, rows);
  }
  return rows;
}

}  // namespace armature
