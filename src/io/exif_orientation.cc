// SPDX-License-Identifier: BSD-3-Clause
#include "io/exif_orientation.h"

#include <cstddef>

namespace armature {
namespace {

constexpr int kUpright = 1, kOrientationTag = 0x0112;

// Whole numbers of a TIFF block, which says at its start in which order their bytes are: high byte first
// where it does not; 0 outside of it.
class TiffBlock {
 public:
  explicit TiffBlock(std::string_view bytes) : bytes_(bytes), is_little_(bytes.starts_with("II")) {}

  size_t Number(size_t at, size_t size) const {
    size_t value = 0;
    if (at > bytes_.size() || size > bytes_.size() - at) return 0;
    for (size_t i = 0; i < size; ++i) {
      const size_t from = is_little_ ? at + size - 1 - i : at + i;
      value = value << 8 | static_cast<unsigned char>(bytes_[from]);
    }
    return value;
  }

 private:
  std::string_view bytes_;
  bool is_little_;
};

// In the first directory: a number of entries, then of each the tag, type, count and value.
int FindInTiff(std::string_view bytes) {
  if (!bytes.starts_with(std::string_view("II*\0", 4)) && !bytes.starts_with(std::string_view("MM\0*", 4)))
    return kUpright;
  const TiffBlock block(bytes);
  const size_t directory = block.Number(4, 4), entries = block.Number(directory, 2);
  for (size_t i = 0; i < entries; ++i) {
    const size_t entry = directory + 2 + 12 * i;
    if (block.Number(entry, 2) != kOrientationTag) continue;
    const size_t value = block.Number(entry + 8, 2);
    return value >= 1 && value <= 8 ? static_cast<int>(value) : kUpright;
  }
  return kUpright;
}

// Segments of a JPEG before its image: 0xFF, a mark, and from there on the length, high byte first.
int FindInJpeg(std::string_view bytes) {
  const std::string_view exif("Exif\0\0", 6);
  for (size_t at = 2; at + 4 <= bytes.size() && bytes[at] == '\xFF';) {
    const auto mark = static_cast<unsigned char>(bytes[at + 1]);
    if (mark == 0xDA) break;  // the image's data
    const size_t length = static_cast<size_t>(static_cast<unsigned char>(bytes[at + 2])) << 8 |
                          static_cast<unsigned char>(bytes[at + 3]);
    const std::string_view content = bytes.substr(at + 4, length < 2 ? 0 : length - 2);
    if (mark == 0xE1 && content.starts_with(exif)) return FindInTiff(content.substr(exif.size()));
    at += 2 + length;
  }
  return kUpright;
}

// Chunks of a PNG: length, type, content, checksum.
int FindInPng(std::string_view bytes) {
  const TiffBlock block(bytes);  // high byte first, too
  for (size_t at = 8; at + 8 <= bytes.size(); at += 12 + block.Number(at, 4)) {
    if (bytes.substr(at + 4, 4) == "eXIf") return FindInTiff(bytes.substr(at + 8));
  }
  return kUpright;
}

}  // namespace

int FindExifOrientation(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xD8")) return FindInJpeg(bytes);
  if (bytes.starts_with("\x89PNG")) return FindInPng(bytes);
  return FindInTiff(bytes);
}

}  // namespace armature
