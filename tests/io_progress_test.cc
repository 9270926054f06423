// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "base/progress.h"

namespace armature {
namespace {

constexpr Screen kTerminal{.is_terminal = true, .colour = false};

// What a progress of so many steps writes.
std::string ProgressText(const std::string& what, long steps, const Screen& screen, int columns = 80) {
  std::ostringstream stream;
  {
    Progress progress(what, steps, {&stream, screen, [=] { return columns; }});
    for (long i = 0; i < steps; ++i) progress.Step();
  }
  return stream.str();
}

// The last bar, without the characters that say where it is drawn.
std::string LastBar(const std::string& text) {
  const size_t start = text.rfind('\r') + 1;
  return text.substr(start, text.rfind("\x1b[K") - start);
}

TEST(Progress, WritesALineEachTenPercent) {
  const std::string text = ProgressText("frames", 250, {});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
  EXPECT_NE(text.find("frames 25/250 (10 %)\n"), std::string::npos);
  EXPECT_NE(text.find("frames 250/250 (100 %)\n"), std::string::npos);
}

TEST(Progress, EndsWithAFullBarAndTheTimeTaken) {
  const std::string text = ProgressText("frames", 4, kTerminal);
  EXPECT_EQ(LastBar(text), "frames [==============================] 4/4  0:00");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
}

TEST(Progress, FitsTheTerminal) {
  EXPECT_EQ(LastBar(ProgressText("frames", 4, kTerminal, 31)), "frames [===========] 4/4  0:00");
  EXPECT_EQ(LastBar(ProgressText("frames", 4, kTerminal, 24)), "frames 4/4  0:00");
  EXPECT_EQ(LastBar(ProgressText("frames", 4, kTerminal, 10)), "frames 4/");
}

TEST(Progress, IsColouredWhereColourIsWanted) {
  EXPECT_EQ(ProgressText("frames", 4, kTerminal).find("\x1b[3"), std::string::npos);
  EXPECT_NE(ProgressText("frames", 4, {.is_terminal = true, .colour = true}).find("\x1b[32m=="),
            std::string::npos);
}

TEST(Progress, CountsNothing) { EXPECT_EQ(ProgressText("frames", 0, kTerminal), ""); }

TEST(Progress, ShowsNothingWithoutAStream) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  {
    Progress progress("frames", 2, ProgressScreen{});
    for (int i = 0; i < 2; ++i) progress.Step();
  }
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(RemainingTime, IsUnknownAtFirst) {
  RemainingTime time;
  EXPECT_FALSE(time.Seconds(10));
  time.Add(5, 0.5);
  EXPECT_FALSE(time.Seconds(10));
}

TEST(RemainingTime, FollowsASteadyPace) {
  RemainingTime time;
  for (int i = 1; i <= 40; ++i) time.Add(i, 0.5 * i);
  EXPECT_NEAR(*time.Seconds(100), 30, 1e-9);
  EXPECT_NEAR(*time.Seconds(40), 0, 1e-9);
}

TEST(RemainingTime, ForgetsSlowFirstSteps) {
  RemainingTime time;
  for (int i = 1; i <= 10; ++i) time.Add(i, 10.0 * i);       // ten steps in 100 s
  for (int i = 1; i <= 200; ++i) time.Add(10 + i, 100 + i);  // then one a second
  EXPECT_NEAR(*time.Seconds(310), 100, 2);
}

TEST(RemainingTime, HardlyMindsASingleSlowStep) {
  RemainingTime time;
  for (int i = 1; i <= 60; ++i) time.Add(i, i);
  time.Add(61, 65);
  EXPECT_NEAR(*time.Seconds(161), 100, 25);
}

TEST(RemainingTime, IsWrittenAsClocksDo) {
  EXPECT_EQ(DurationText(4.6), "0:05");
  EXPECT_EQ(DurationText(80), "1:20");
  EXPECT_EQ(DurationText(3723), "1:02:03");
}

}  // namespace
}  // namespace armature
