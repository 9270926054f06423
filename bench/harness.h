// SPDX-License-Identifier: BSD-3-Clause
// The harness: contenders take turns on the same numbered inputs, so that whatever else the machine does hits
// all of them alike.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/engine.h"

namespace armature {

// One timed run.
struct BenchRow {
  std::string contender;
  size_t repetition = 0;
  size_t input = 0;
  double wall_ms = 0;  // steady clock around `run`, a call
  FrameOutcome outcome;

  // What the frame costs: the time that passed and what was counted without waiting.
  double total_ms() const { return wall_ms + outcome.added_ms; }
};

// Something that is timed: an engine on the frames of a sequence, or a stage on fixed inputs.
struct Contender {
  std::string name;
  size_t every = 1;             // takes part only in every n-th input, for what is slow and remembers nothing
  std::function<void()> start;  // before each repetition, not timed; may be empty
  std::function<FrameOutcome(size_t input)> run;  // timed
  double calls = 1;                               // that one `run` makes: rows are milliseconds a call
  // Whether it takes part in an input at all, warm-up included; `every` counts those. Empty: in each of them.
  std::function<bool(size_t input)> wants{};
  // Before each of its runs, not timed; may be empty.
  std::function<void()> before{};
  // Looks at a row that counts, not timed, and may take from it what need not be kept; may be empty.
  std::function<void(BenchRow& row)> after{};
};

// Runs the engine on the sequence's frames. Both have to outlive the contender.
Contender MakeContender(const std::string& name, Engine& engine, const BenchSequence& sequence);

struct HarnessOptions {
  size_t warm_up = 5;      // first inputs of each repetition that every contender sees, but that do not count
  size_t repetitions = 1;  // of all inputs, from the start
};

// Throws InputError when there are not more inputs than warm-up.
void CheckLongerThanWarmUp(size_t inputs, const HarnessOptions& options);

// Rows in the order in which they were measured, without the warm-up. On each input the turn begins with
// another contender. Throws as CheckLongerThanWarmUp.
std::vector<BenchRow> RunInterleaved(const std::vector<Contender>& contenders, size_t inputs,
                                     const HarnessOptions& options);

}  // namespace armature
