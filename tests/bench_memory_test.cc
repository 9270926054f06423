// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "bench/peak_memory.h"
#include "support/expect_input_error.h"

namespace armature {
namespace {

// Takes memory from the system, writes to every page and gives it back; no allocator of a sanitizer keeps it.
void Touch(size_t megabytes) {
  const size_t size = megabytes << 20;
  void* memory = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::runtime_error("no memory");
  std::memset(memory, 1, size);
  munmap(memory, size);
}

#ifdef ARMATURE_SANITIZED
constexpr double kShadow = 100.0 / 8;  // megabytes: what the sanitizer may keep of what is touched
#else
constexpr double kShadow = 0;
#endif

void ExpectHundred(double megabytes) {
  EXPECT_GT(megabytes, 95);
  EXPECT_LT(megabytes, 105 + kShadow);
}

TEST(PeakMemory, IsThatOfTheWork) {
  const PeakMemory none = MeasurePeakMemory([] {});
  const PeakMemory some = MeasurePeakMemory([] { Touch(100); });
  EXPECT_GT(none.before_mb, 1);
  ExpectHundred(some.peak_mb - none.peak_mb);
  ExpectHundred(some.added_mb() - none.added_mb());
}

TEST(PeakMemory, DoesNotCountWhatTheParentHasFreed) {
  const PeakMemory before = MeasurePeakMemory([] {});
  Touch(150);
  EXPECT_NEAR(MeasurePeakMemory([] {}).peak_mb, before.peak_mb, 20);
}

TEST(PeakMemory, LeavesTheParentAsItIs) {
  int value = 1;
  MeasurePeakMemory([&value] { value = 2; });
  EXPECT_EQ(value, 1);
}

TEST(PeakMemory, ThrowsTheOutputAway) {
  ::testing::internal::CaptureStdout();
  MeasurePeakMemory([] {
    std::puts("not to be seen");
    std::fflush(stdout);
  });
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

TEST(PeakMemory, PassesOnWhatIsWrong) {
  testing::ExpectInputError([] { MeasurePeakMemory([] { throw InputError("a.png: no such image"); }); },
                            {"a.png: no such image"});
  try {
    MeasurePeakMemory([] { throw std::runtime_error("it broke"); });
    ADD_FAILURE() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "measuring memory: it broke");
  }
}

TEST(PeakMemory, ReportsAChildThatIsEnded) {
  try {
    MeasurePeakMemory([] { kill(getpid(), SIGKILL); });
    ADD_FAILURE() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("Killed"), std::string::npos);
  }
}

}  // namespace
}  // namespace armature
