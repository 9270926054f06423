// SPDX-License-Identifier: BSD-3-Clause
// Texts of others (names, paths, lines of files) made harmless for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace armature {

// With '?' for each control character, also those of more than one byte and those that turn the direction of
// writing, and for each byte that is no UTF-8.
std::string Printable(std::string_view text);

// The same for a text of several lines: line breaks stay.
std::string PrintableLines(std::string_view text);

// Whether the text is as it is printed.
bool IsPrintable(std::string_view text);

// At most so many bytes, cut between characters.
std::string_view FirstBytes(std::string_view text, size_t most);

}  // namespace armature
