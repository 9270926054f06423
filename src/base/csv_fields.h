// SPDX-License-Identifier: BSD-3-Clause
// Fields of comma-separated lines, as RFC 4180 quotes them: names may have commas in them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace armature {

// As it is, or in double quotes, those in it twice, where it has a comma, a quote or a line break.
std::string CsvField(std::string_view text);

// The other way round. What is between the commas, trimmed; in quotes as it is. A quote within a field that
// does not start with one is an ordinary character; one that is not closed reaches to the end.
std::vector<std::string> SplitCsvFields(const std::string& line);

}  // namespace armature
