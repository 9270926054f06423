// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "base/checksum.h"

namespace armature {
namespace {

std::vector<std::byte> CountingBytes(size_t size) {
  std::vector<std::byte> bytes(size);
  for (size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>(i);
  return bytes;
}

// Computed by hand from the recipe: a file written by one version is read by the next.
TEST(Checksum, StaysWhatItWas) {
  EXPECT_EQ(Checksum({}), 0x68853b6a3912cca3u);
  EXPECT_EQ(Checksum(CountingBytes(11)), 0xb31143f83a408fe3u);
}

TEST(Checksum, EveryFlippedBitShows) {
  std::vector<std::byte> bytes = CountingBytes(21);
  std::set<std::uint64_t> sums{Checksum(bytes)};
  for (size_t i = 0; i < bytes.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      bytes[i] ^= std::byte{1} << bit;
      sums.insert(Checksum(bytes));
      bytes[i] ^= std::byte{1} << bit;
    }
  }
  EXPECT_EQ(sums.size(), 1 + 21u * 8);
}

TEST(Checksum, ZerosAtTheEndCount) {
  std::set<std::uint64_t> sums;
  for (size_t size = 0; size < 20; ++size) sums.insert(Checksum(std::vector<std::byte>(size)));
  EXPECT_EQ(sums.size(), 20u);
}

TEST(Checksum, OrderOfWordsCounts) {
  std::vector<std::byte> bytes = CountingBytes(16);
  const std::uint64_t before = Checksum(bytes);
  std::swap_ranges(bytes.begin(), bytes.begin() + 8, bytes.begin() + 8);
  EXPECT_NE(Checksum(bytes), before);
}

}  // namespace
}  // namespace armature
