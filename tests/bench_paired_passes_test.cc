// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "bench/guard/paired_passes.h"
#include "support/expect_input_error.h"
#include "support/program.h"

namespace armature {
namespace {

constexpr const char* kPassHeader =
    "table,sequence,contender,repetition,frame,objects,segments,detection,association,optimization,mapping,"
    "added,"
    "total\n";

// Frames 0..n-1 of one contender, times growing with the frame.
std::string Passes(const std::string& contender, int n, double factor) {
  std::string text;
  for (int i = 0; i < n; ++i)
    text += "comparison,s," + contender + ",0," + std::to_string(i) + ",3,9," +
            std::to_string(factor * (1 + i)) + ",0,,,0," + std::to_string(factor * (2 + i)) + "\n";
  return text;
}

TEST(PairedPasses, TellHowManyTimesAsLongEachSpanTakes) {
  const testing::TempFolder folder;
  const auto a = folder.Write("a.csv", kPassHeader + Passes("lines", 8, 1) + Passes("gone", 8, 1));
  const auto b = folder.Write("b.csv", kPassHeader + Passes("lines", 9, 1.5));
  const auto spans = PairPasses(a, b);
  ASSERT_EQ(spans.size(), 2u);  // association never had anything to do
  EXPECT_EQ(spans[0].name, "comparison/s/lines/detection");
  const Table table = PassRatioTable(spans, 1);
  EXPECT_EQ(table.rows[1][0].text, "comparison/s/lines/total");
  EXPECT_EQ(table.rows[1][3].text, "1.500");
  EXPECT_EQ(table.rows[1][6].text, "higher");
  EXPECT_EQ(table.rows[1][7].text, "8");
  EXPECT_EQ(table.rows[1][9].text, "1");  // frame 8
  const Table on_slow_machine = PassRatioTable(spans, 1.45);
  EXPECT_EQ(on_slow_machine.rows[1][3].text, "1.034");
  EXPECT_EQ(on_slow_machine.rows[1][6].text, "same");
}

TEST(PairedPasses, LeaveOutTimesThatAreNoWorkOfTheMachine) {
  const testing::TempFolder folder;
  const auto raw = folder.Write("a.csv", kPassHeader + Passes("keypoints:wait", 8, 1));
  EXPECT_TRUE(PairPasses(raw, raw).empty());
}

TEST(PairedPasses, RefuseAPassThatIsThereTwice) {
  const testing::TempFolder folder;
  const auto raw = folder.Write("a.csv", kPassHeader + Passes("lines", 1, 1) + Passes("lines", 1, 1));
  testing::ExpectInputError([&] { PairPasses(raw, raw); }, {"a.csv:3", "twice"});
}

TEST(PairedPasses, OfABenchmarkWithItselfAreTheSame) {
  const testing::TempFolder folder;
  testing::RunOk({"bench", "--tables", "micro", "--micro", "matching:chair", "--out", folder / "out"});
  const auto result = testing::RunOk({"compare", folder / "out", folder / "out", "--format", "csv"});
  EXPECT_NE(result.out.find("micro//matching:chair/total"), std::string::npos) << result.out;
  EXPECT_EQ(result.out.find(",higher,"), std::string::npos) << result.out;
  EXPECT_EQ(result.err, "");
}

}  // namespace
}  // namespace armature
