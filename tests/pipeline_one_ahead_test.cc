// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>

#include "pipeline/one_ahead.h"

namespace armature {
namespace {

TEST(OneAhead, HandsOutTheItemsInOrder) {
  OneAhead<int> squares(50, [](size_t i) { return static_cast<int>(i * i); });
  for (int i = 0; i < 50; ++i) EXPECT_EQ(squares.Take(), i * i);
}

TEST(OneAhead, IsNeverMoreThanOneAhead) {
  std::atomic<int> made{0}, taken{0};
  std::atomic<bool> too_far{false};
  OneAhead<int> items(200, [&](size_t) {
    // Made and not taken: one that waits, and one that was begun when the last was taken.
    if (made - taken > 2) too_far = true;
    return ++made;
  });
  for (int i = 1; i <= 200; ++i) {
    EXPECT_EQ(items.Take(), i);
    ++taken;
  }
  EXPECT_FALSE(too_far);
}

TEST(OneAhead, ThrowsInTheTurnOfTheItemThatFailed) {
  OneAhead<int> items(5, [](size_t i) {
    if (i == 2) throw std::runtime_error("no third one");
    return static_cast<int>(i);
  });
  EXPECT_EQ(items.Take(), 0);
  EXPECT_EQ(items.Take(), 1);
  EXPECT_THROW(items.Take(), std::runtime_error);
}

TEST(OneAhead, MayBeLeftBeforeTheEnd) {
  std::atomic<int> made{0};
  {
    OneAhead<int> items(1000, [&](size_t) { return ++made; });
    items.Take();
  }
  EXPECT_LT(made, 10);
}

TEST(OneAhead, OfNothingEndsAtOnce) {
  bool made = false;
  {
    OneAhead<int> nothing(0, [&](size_t) { return made = true, 1; });
  }
  EXPECT_FALSE(made);
}

}  // namespace
}  // namespace armature
