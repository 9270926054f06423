// SPDX-License-Identifier: BSD-3-Clause
#include "base/checksum.h"

#include <cstring>

namespace armature {
namespace {

constexpr std::uint64_t kOffset = 0xCBF29CE484222325;
constexpr std::uint64_t kPrime = 0x100000001B3;

// Both steps can be undone, so words that differ give sums that differ.
std::uint64_t Mixed(std::uint64_t sum, std::uint64_t word) {
  sum = (sum ^ word) * kPrime;
  return sum ^ (sum >> 32);
}

}  // namespace

std::uint64_t Checksum(std::span<const std::byte> bytes) {
  std::uint64_t sum = kOffset;
  size_t at = 0;
  for (; at + sizeof(std::uint64_t) <= bytes.size(); at += sizeof(std::uint64_t)) {
    std::uint64_t word;
    std::memcpy(&word, bytes.data() + at, sizeof(word));
    sum = Mixed(sum, word);
  }
  std::uint64_t rest = 0;
  if (at < bytes.size()) std::memcpy(&rest, bytes.data() + at, bytes.size() - at);
  return Mixed(Mixed(sum, rest), bytes.size());
}

}  // namespace armature
