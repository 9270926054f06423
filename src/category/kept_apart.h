// SPDX-License-Identifier: BSD-3-Clause
// Which models of a published collection rooms are drawn from: those are not to be learnt from.
#pragma once

#include <cstdint>
#include <string_view>

namespace armature {

constexpr std::uint64_t kKeptApartEvery = 5;

// By the id alone, so that it holds whatever else is in a collection: FNV-1a (64 bits) of the id's bytes is
// divisible by kKeptApartEvery.
constexpr bool IsKeptApart(std::string_view id) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : id) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return hash % kKeptApartEvery == 0;
}

}  // namespace armature
