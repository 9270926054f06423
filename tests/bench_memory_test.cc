// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "bench/peak_memory.h"
#include "support/expect_input_error.h"

namespace armature {
namespace {

// Writes to every page.
void Touch(size_t megabytes) {
  std::vector<char> memory(megabytes << 20, 1);
  volatile char* bytes = memory.data();
  for (size_t i = 0; i < memory.size(); i += 4096) bytes[i] = 2;
}

TEST(PeakMemory, IsThatOfTheWork) {
  const PeakMemory none = PeakMemoryOf([] {});
  const PeakMemory some = PeakMemoryOf([] { Touch(100); });
  EXPECT_GT(none.before_mb, 1);
  EXPECT_NEAR(some.peak_mb - none.peak_mb, 100, 5);
  EXPECT_NEAR(some.added_mb() - none.added_mb(), 100, 5);
}

TEST(PeakMemory, DoesNotCountWhatTheParentHasFreed) {
  const PeakMemory before = PeakMemoryOf([] {});
  Touch(150);
  EXPECT_NEAR(PeakMemoryOf([] {}).peak_mb, before.peak_mb, 20);
}

TEST(PeakMemory, LeavesTheParentAsItIs) {
  int value = 1;
  PeakMemoryOf([&value] { value = 2; });
  EXPECT_EQ(value, 1);
}

TEST(PeakMemory, ThrowsTheOutputAway) {
  ::testing::internal::CaptureStdout();
  PeakMemoryOf([] {
    std::puts("not to be seen");
    std::fflush(stdout);
  });
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

TEST(PeakMemory, PassesOnWhatIsWrong) {
  testing::ExpectInputError([] { PeakMemoryOf([] { throw InputError("a.png: no such image"); }); },
                            {"a.png: no such image"});
  try {
    PeakMemoryOf([] { throw std::runtime_error("it broke"); });
    ADD_FAILURE() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "measuring memory: it broke");
  }
}

TEST(PeakMemory, ReportsAChildThatIsEnded) {
  try {
    PeakMemoryOf([] { kill(getpid(), SIGKILL); });
    ADD_FAILURE() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("Killed"), std::string::npos);
  }
}

}  // namespace
}  // namespace armature
