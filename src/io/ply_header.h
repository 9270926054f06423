// SPDX-License-Identifier: BSD-3-Clause
// What a PLY file says of its own layout.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armature {

enum class PlyFormat { kText, kLittleEndian, kBigEndian };

struct PlyScalar {
  enum class Kind { kSigned, kUnsigned, kReal } kind = Kind::kReal;
  size_t bytes = 4;
};

struct PlyProperty {
  std::string name;
  PlyScalar type;                  // of each value
  std::optional<PlyScalar> count;  // of a list, which begins with it
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;  // in the order of the data

  // Index of the property, none when there is none of this name.
  std::optional<size_t> Find(std::string_view property) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::kText;
  std::vector<PlyElement> elements;  // in the order of the data
  size_t bytes = 0;                  // up to the data
  int lines = 0;
};

// Throws InputError naming file and line: not a PLY file, a header without end, a line that is none of PLY's,
// an element or a property twice.
PlyHeader ReadPlyHeader(std::string_view content, const std::filesystem::path& file);

}  // namespace armature
