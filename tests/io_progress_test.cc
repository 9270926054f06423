// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "io/progress.h"

namespace armature {
namespace {

TEST(Progress, WritesALineEachTenPercent) {
  std::ostringstream stream;
  {
    Progress progress("frames", 250, stream, /*is_terminal=*/false);
    for (int i = 0; i < 250; ++i) progress.Step();
  }
  const std::string text = stream.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
  EXPECT_NE(text.find("frames 25/250 (10 %)\n"), std::string::npos);
  EXPECT_NE(text.find("frames 250/250 (100 %)\n"), std::string::npos);
}

TEST(Progress, DrawsABarOnATerminal) {
  std::ostringstream stream;
  {
    Progress progress("frames", 4, stream, /*is_terminal=*/true);
    for (int i = 0; i < 4; ++i) progress.Step();
  }
  const std::string text = stream.str();
  EXPECT_TRUE(text.ends_with("[==============================] 4/4\n"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
}

TEST(Progress, CountsNothing) {
  std::ostringstream stream;
  { const Progress progress("frames", 0, stream, /*is_terminal=*/true); }
  EXPECT_EQ(stream.str(), "");
}

}  // namespace
}  // namespace armature
