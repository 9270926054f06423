// SPDX-License-Identifier: BSD-3-Clause
// Small helpers of the readers: lines, words and numbers of text files, and texts as they are shown in a
// message. Blanks are spaces, tabs, carriage returns, vertical tabs and form feeds, everywhere.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace armature {

struct TextLine {
  int number = 0;    // from 1
  std::string text;  // trimmed, never empty
};

// Where a comment may begin. A '#' within a word never begins one.
enum class Comments {
  kAnywhere,  // at the start of a line, or after a blank
  kOwnLines   // at the start alone: the rest of the line may be any file name
};

// The lines that carry content: blank lines and comments are left out. Lines end in LF, CR LF or CR; the last
// one may end with the file. Throws InputError when the file cannot be read, or is no text: it holds a zero
// byte.
std::vector<TextLine> ReadTextLines(const std::filesystem::path& file,
                                    Comments comments = Comments::kAnywhere);

// The lines of such a file's content; `name` is for messages.
std::vector<TextLine> SplitLines(std::string_view content, const std::string& name,
                                 Comments comments = Comments::kAnywhere);

// Up to the first '#' that stands at the start or after a blank.
std::string WithoutComment(const std::string& line);

// The whole file, text or not. Throws InputError when it cannot be read (input_file.h).
std::string ReadTextFile(const std::filesystem::path& file);

// Without blanks at both ends.
std::string Trimmed(std::string_view text);

// What is between blanks; nothing of a blank line.
std::vector<std::string> SplitWords(std::string_view line);

// What is between the commas, trimmed; one text where there is none.
std::vector<std::string> SplitFields(const std::string& line);

// In single quotes, for messages: always one line, shortened when it is long, control characters as '?'.
std::string Quoted(std::string_view text);

// A finite number from the whole of the text; throws InputError("`where`: ...") otherwise. A sign '+' and
// exponents after Fortran's 'D' are taken; what is too small for a double is 0.
double ParseNumber(const std::string& text, const std::string& where);

// Numbers with `;` between them; nothing: none. As ParseNumber.
std::vector<double> ParseNumbers(const std::string& text, const std::string& where);

// A whole number that fits an int, as ParseNumber.
int ParseInteger(const std::string& text, const std::string& where);

}  // namespace armature
