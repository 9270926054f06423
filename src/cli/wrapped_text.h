// SPDX-License-Identifier: BSD-3-Clause
// Text in lines of a given width.
#pragma once

#include <string>

namespace armature {

// Lines of at most so many columns, broken at blanks; line breaks of the text stay. Ends with a line break.
std::string Wrapped(const std::string& text, size_t columns);

struct ColumnLayout {
  size_t name = 0;     // column where names start
  size_t meaning = 0;  // and meanings
  size_t end = 0;      // columns of a line
};

// A name and beside it its meaning, or below it where the name is too long.
std::string TwoColumns(const std::string& name, const std::string& meaning, const ColumnLayout& layout);

}  // namespace armature
