// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "bench/harness.h"
#include "support/expect_input_error.h"

namespace armature {
namespace {

// Contenders that write down when they are called.
struct HarnessLog {
  std::vector<std::string> calls;

  Contender Make(const std::string& name, size_t every = 1) {
    return {.name = name,
            .every = every,
            .start = [this, name] { calls.push_back(name + " starts"); },
            .run =
                [this, name](size_t input) {
                  calls.push_back(name + std::to_string(input));
                  FrameOutcome outcome;
                  outcome.objects = static_cast<int>(input);
                  return outcome;
                },
            .calls = 1};
  }
};

TEST(Harness, TakesTurnsAndBeginsEachInputWithAnother) {
  HarnessLog log;
  RunInterleaved({log.Make("a"), log.Make("b")}, 3, {.warm_up = 0, .repetitions = 1});
  EXPECT_EQ(log.calls,
            (std::vector<std::string>{"a starts", "b starts", "a0", "b0", "b1", "a1", "a2", "b2"}));
}

TEST(Harness, DiscardsTheWarmUpOfEachRepetition) {
  HarnessLog log;
  const std::vector<BenchRow> rows = RunInterleaved({log.Make("a")}, 4, {.warm_up = 2, .repetitions = 2});
  EXPECT_EQ(log.calls, (std::vector<std::string>{"a starts", "a0", "a1", "a2", "a3", "a starts", "a0", "a1",
                                                 "a2", "a3"}));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].input, 2U);
  EXPECT_EQ(rows[1].input, 3U);
  EXPECT_EQ(rows[2].repetition, 1U);
  EXPECT_EQ(rows[3].outcome.objects, 3);
}

TEST(Harness, LeavesInputsOutForSlowContendersButNotTheWarmUp) {
  HarnessLog log;
  const std::vector<BenchRow> rows =
      RunInterleaved({log.Make("slow", 3)}, 6, {.warm_up = 2, .repetitions = 1});
  EXPECT_EQ(log.calls, (std::vector<std::string>{"slow starts", "slow0", "slow1", "slow2", "slow5"}));
  EXPECT_EQ(rows.size(), 2U);
}

TEST(Harness, DividesByTheCallsAndAddsWhatWasNotWaitedFor) {
  Contender contender = HarnessLog().Make("a");
  contender.start = {};
  contender.run = [](size_t) {
    FrameOutcome outcome;
    outcome.added_ms = 855;
    return outcome;
  };
  contender.calls = 1e9;  // nothing takes a million seconds
  const std::vector<BenchRow> rows = RunInterleaved({contender}, 1, {.warm_up = 0, .repetitions = 1});
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_GE(rows[0].wall_ms, 0);
  EXPECT_LT(rows[0].wall_ms, 1);
  EXPECT_DOUBLE_EQ(rows[0].total_ms(), rows[0].wall_ms + 855);
}

TEST(Harness, RefusesARunNoLongerThanTheWarmUp) {
  HarnessLog log;
  testing::ExpectInputError([&] { RunInterleaved({log.Make("a")}, 5, {.warm_up = 5, .repetitions = 1}); },
                            {"5 frames", "warm-up of 5", "--warm-up"});
  EXPECT_TRUE(log.calls.empty());
}

}  // namespace
}  // namespace armature
