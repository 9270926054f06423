// SPDX-License-Identifier: BSD-3-Clause
// What FLANN 1.9.2 has saved, read from memory. Not by its own LoadArchive, which believes the sizes in the
// bytes and throws out of its destructor where they end early.
#pragma once

#include <flann/util/saving.h>
#include <flann/util/serialization.h>
#include <fmt/format.h>
#include <lz4.h>

#include <array>
#include <cstring>
#include <string_view>
#include <vector>

#include "base/errors.h"

namespace armature {

[[noreturn]] inline void RefuseStructure(const char* why) { throw InputError(why); }

// A header as it is in memory, then blocks, each compressed with the one before it as its dictionary; the
// size of a block stands before it, the first one's in the header, and 0 behind the last. No value is in two
// blocks.
class FlannArchive : public flann::serialization::InputArchive<FlannArchive> {
 public:
  explicit FlannArchive(std::string_view saved) : rest_(saved) {
    flann::IndexHeaderStruct header;
    TakeInto(&header, sizeof header);
    if (std::memcmp(header.signature, FLANN_SIGNATURE_, sizeof FLANN_SIGNATURE_) != 0)
      RefuseStructure("it is not one of this FLANN");
    if (header.compression != 1) RefuseStructure("it is not compressed as FLANN does");
    first_block_ = header.first_block_size;
    LZ4_setStreamDecode(&stream_, nullptr, 0);
    block_ = saved.substr(0, sizeof header);  // FLANN reads it again
  }

  template <typename T>
  void load(T& value) {
    load_binary(&value, sizeof value);
  }
  void load(bool& value) {
    unsigned char byte = 0;
    load(byte);
    if (byte > 1) RefuseStructure("a truth value is neither true nor false");
    value = byte == 1;
  }
  template <typename T>
  void load(T*& /*pointer*/) {}  // as FLANN: none is saved

  template <typename T>
  void load_binary(T* bytes, size_t size) {
    if (block_.empty()) NextBlock();
    if (size > block_.size()) RefuseStructure("it ends early");
    std::memcpy(bytes, block_.data(), size);
    block_.remove_prefix(size);
  }

  // Throws unless everything was read.
  void Finish() {
    size_t end = 1;
    TakeInto(&end, sizeof end);
    if (end != 0 || !block_.empty() || !rest_.empty()) RefuseStructure("it goes on behind its end");
  }

 private:
  void TakeInto(void* bytes, size_t size) {
    if (size > rest_.size()) RefuseStructure("it ends early");
    std::memcpy(bytes, rest_.data(), size);
    rest_.remove_prefix(size);
  }

  void NextBlock() {
    size_t size = first_block_;
    if (blocks_ > 0) TakeInto(&size, sizeof size);
    if (size == 0 || size > rest_.size() || size > LZ4_COMPRESSBOUND(kBlock))
      RefuseStructure("it ends early");
    std::array<char, kBlock>& buffer = buffers_[blocks_++ % 2];
    const int bytes = LZ4_decompress_safe_continue(&stream_, rest_.data(), buffer.data(),
                                                   static_cast<int>(size), static_cast<int>(kBlock));
    if (bytes <= 0) RefuseStructure("a block cannot be decompressed");
    rest_.remove_prefix(size);
    block_ = {buffer.data(), static_cast<size_t>(bytes)};
  }

  static constexpr size_t kBlock = size_t{1} << 16;

  std::string_view rest_;   // not yet decompressed
  std::string_view block_;  // not yet read
  size_t first_block_ = 0, blocks_ = 0;
  LZ4_streamDecode_t stream_;
  std::vector<std::array<char, kBlock>> buffers_{2};
};

}  // namespace armature
