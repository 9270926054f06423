// SPDX-License-Identifier: BSD-3-Clause
// Small helpers of the readers: lines of a text file, and texts as they are shown in a message.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace armature {

struct TextLine {
  int number = 0;    // from 1
  std::string text;  // trimmed, never empty
};

// The lines that carry content: blank lines and comments ('#' at the start or after a blank) are left out.
// Throws InputError when the file cannot be read.
std::vector<TextLine> ReadTextLines(const std::filesystem::path& file);

// The whole file. Throws InputError when it cannot be read.
std::string ReadTextFile(const std::filesystem::path& file);

// Without blanks, tabs and carriage returns at both ends.
std::string Trimmed(const std::string& text);

// What is between the commas, trimmed; one text where there is none.
std::vector<std::string> SplitFields(const std::string& line);

// In single quotes, for messages: always one line, shortened when it is long.
std::string Quoted(const std::string& text);

// A finite number from the whole of the text; throws InputError("`where`: ...") otherwise.
double ParseNumber(const std::string& text, const std::string& where);

// Numbers with `;` between them; nothing: none. As ParseNumber.
std::vector<double> ParseNumbers(const std::string& text, const std::string& where);

// A whole number that fits an int, as ParseNumber.
int ParseInteger(const std::string& text, const std::string& where);

}  // namespace armature
