// SPDX-License-Identifier: BSD-3-Clause
#include "base/printable.h"

#include <cstdint>

namespace armature {
namespace {

struct Character {
  std::uint32_t code = 0;
  size_t bytes = 1;
  bool is_valid = false;
};

unsigned char ByteAt(std::string_view text, size_t i) { return static_cast<unsigned char>(text[i]); }

size_t LengthFrom(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead < 0xE0) return 2;
  if (lead >= 0xE0 && lead < 0xF0) return 3;
  return lead >= 0xF0 && lead < 0xF5 ? 4 : 0;
}

// The first character of a text that is not empty.
Character FirstCharacter(std::string_view text) {
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};  // shorter forms are not allowed
  const size_t length = LengthFrom(ByteAt(text, 0));
  if (length == 0 || length > text.size()) return {};
  if (length == 1) return {ByteAt(text, 0), 1, true};
  std::uint32_t code = ByteAt(text, 0) & (0x7FU >> length);
  for (size_t i = 1; i < length; ++i) {
    if ((ByteAt(text, i) & 0xC0) != 0x80) return {};
    code = code << 6 | (ByteAt(text, i) & 0x3FU);
  }
  const bool is_surrogate = code >= 0xD800 && code < 0xE000;
  if (code < kLeast[length] || is_surrogate || code > 0x10FFFF) return {};
  return {code, length, true};
}

// Unicode's C0, C1, line separators, and marks and overrides of direction.
bool IsControl(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x200E || code == 0x200F ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

std::string Replaced(std::string_view text, bool keep_lines) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const Character character = FirstCharacter(text);
    const bool is_kept = keep_lines && character.code == '\n' && character.is_valid;
    if (character.is_valid && (is_kept || !IsControl(character.code))) {
      shown += text.substr(0, character.bytes);
    } else {
      shown += '?';
    }
    text.remove_prefix(character.bytes);
  }
  return shown;
}

}  // namespace

std::string Printable(std::string_view text) { return Replaced(text, false); }

std::string PrintableLines(std::string_view text) { return Replaced(text, true); }

bool IsPrintable(std::string_view text) { return Printable(text) == text; }

std::string_view FirstBytes(std::string_view text, size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (ByteAt(text, most) & 0xC0) == 0x80) --most;
  return text.substr(0, most);
}

}  // namespace armature
