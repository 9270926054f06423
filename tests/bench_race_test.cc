// SPDX-License-Identifier: BSD-3-Clause
// Who takes part in which input, and what of it counts.
#include <gtest/gtest.h>

#include "bench/sections/calibrated_race.h"
#include "support/bench_fakes.h"
#include "support/expect_input_error.h"

namespace armature {
namespace {

using testing::BoxSequence;
using testing::CountingEngine;

std::vector<size_t> InputsOf(const std::vector<BenchRow>& rows, const std::string& contender) {
  std::vector<size_t> inputs;
  for (const BenchRow& row : rows) {
    if (row.contender == contender) inputs.push_back(row.input);
  }
  return inputs;
}

TEST(Race, CountsAllFramesButTheWarmUpInEachRepetition) {
  const BenchSequence sequence = BoxSequence({1, 2, 3, 4});
  CountingEngine engine(false);
  const auto rows =
      RunInterleaved({MakeContender("a", engine, sequence)}, 4, {.warm_up = 1, .repetitions = 2});
  EXPECT_EQ(InputsOf(rows, "a"), (std::vector<size_t>{1, 2, 3, 1, 2, 3}));
  EXPECT_EQ(engine.seen.size(), 8u);
  EXPECT_EQ(engine.starts, 2);
  EXPECT_EQ(rows[0].outcome.objects, 2);
  EXPECT_GE(rows[0].total_ms(), 200);  // counted, not waited for
  EXPECT_LT(rows[0].wall_ms, 200);
}

TEST(Race, TheTurnBeginsWithAnotherContenderOnEachFrame) {
  const BenchSequence sequence = BoxSequence({1, 1, 1});
  CountingEngine a(false), b(false);
  const auto rows =
      RunInterleaved({MakeContender("a", a, sequence), MakeContender("b", b, sequence)}, 3, {.warm_up = 0});
  std::string order;
  for (const BenchRow& row : rows) order += row.contender;
  EXPECT_EQ(order, "abbaab");
}

TEST(Race, AContenderLooksAtRowsThatCountAndMayEmptyThem) {
  const BenchSequence sequence = BoxSequence({1, 2, 3});
  CountingEngine engine(false);
  Contender contender = MakeContender("a", engine, sequence);
  size_t estimates = 0;
  contender.after = [&](BenchRow& row) {
    estimates += row.outcome.estimates.size();
    row.outcome.estimates.clear();
  };
  const auto rows = RunInterleaved({contender}, 3, {.warm_up = 1});
  EXPECT_EQ(estimates, 5u);
  EXPECT_TRUE(rows.back().outcome.estimates.empty());
}

TEST(Race, AContenderGetsReadyWithoutTheClock) {
  std::string order;
  Contender contender{.name = "a", .start = {}, .run = [&](size_t) {
                        order += "r";
                        return FrameOutcome{};
                      }};
  contender.before = [&] { order += "b"; };
  RunInterleaved({contender}, 2, {.warm_up = 1});
  EXPECT_EQ(order, "brbr");
}

TEST(Race, TheCalibrationTakesItsTurnsApart) {
  const BenchSequence sequence = BoxSequence({1, 2, 3});
  CountingEngine engine(false);
  BenchSection section{.name = "comparison", .sequence = "boxes"};
  RaceCalibrated({MakeContender("a", engine, sequence)}, 3, {.warm_up = 1, .repetitions = 2}, section);
  EXPECT_EQ(InputsOf(section.rows, "a"), (std::vector<size_t>{1, 2, 1, 2}));
  EXPECT_EQ(section.rows.size(), 4u);
  EXPECT_EQ(section.calibration_ms.size(), 4u);
  EXPECT_EQ(section.frames, 2u);
  EXPECT_EQ(section.warmed_up, 1u);
}

TEST(Race, ASparseContenderSeesOnlyWhatIsUsedAndAShortWarmUp) {
  const BenchSequence sequence = BoxSequence({3, 3, 3, 3, 1, 3, 2, 3, 3, 3});  // used after 3: 3, 5, 7, 8, 9
  CountingEngine sparse(true), full(false);
  std::vector<Contender> contenders{MakeContender("sparse", sparse, sequence),
                                    MakeContender("full", full, sequence)};
  const auto is_used = [&](size_t input) { return sequence.frames[input].input.detections.size() == 3; };
  contenders[0].wants = PickOne(SparseInputs(is_used, 10, 3, 2));
  const auto rows = RunInterleaved(contenders, 10, {.warm_up = 3});
  EXPECT_EQ(InputsOf(rows, "sparse"), (std::vector<size_t>{3, 7, 9}));  // every second one
  EXPECT_EQ(sparse.seen.size(), 3u + kSparseWarmUp);
  EXPECT_EQ(InputsOf(rows, "full").size(), 7u);
}

TEST(Race, NoMoreInputsThanWarmUpAreAnError) {
  const BenchSequence sequence = BoxSequence({1, 1, 1});
  CountingEngine engine(false);
  testing::ExpectInputError(
      [&] { RunInterleaved({MakeContender("a", engine, sequence)}, 3, {.warm_up = 3}); },
      {"3 frames", "--warm-up"});
}

}  // namespace
}  // namespace armature
