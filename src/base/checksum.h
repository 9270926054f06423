// SPDX-License-Identifier: BSD-3-Clause
// Whether bytes are still those that were written: finds accidents, not forgeries.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace armature {

// FNV-1a's recipe (Fowler, Noll, Vo; 64 bits) over eight little-endian bytes at a time instead of one, with a
// fold after each so that high bits reach low ones; the number of bytes goes in last. The same on every
// little-endian machine, and never the same for two inputs of one length that differ in one word.
std::uint64_t Checksum(std::span<const std::byte> bytes);

}  // namespace armature
