// SPDX-License-Identifier: BSD-3-Clause
// Tables back from the JSON that commands print and keep.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "io/text_table.h"

namespace armature {

// One table as FormatTable writes it, or an array of such. JSON drops the zeros at a number's end; a column
// gets them back up to its longest number (not in the table "paper", where rows differ). Throws InputError,
// starting with `where`, for anything else.
std::vector<Table> TablesFromJson(const nlohmann::ordered_json& json, const std::string& where);

// The same of a file; also of one that keeps its tables in a member "tables", as eval.json and bench.json do.
// Throws InputError.
std::vector<Table> ReadTables(const std::filesystem::path& file);

}  // namespace armature
