// SPDX-License-Identifier: BSD-3-Clause
// What commands that print several tables share.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "cli/configuration.h"
#include "io/text_table.h"

namespace armature {

// The tables one after the other, a blank line between; in JSON one array.
std::string FormatTables(const std::vector<Table>& tables, TableFormat format);

// tables.txt, .md, .csv and .tex in the folder, each of what `text` gives for its format. Throws InputError
// for a file that cannot be written.
void WriteTableFiles(const std::filesystem::path& folder,
                     const std::function<std::string(TableFormat)>& text);

// --format and --json.
void AddFormatArguments(CLI::App& command, std::string& format, bool& json);

// --categories and --configs alone, for commands that read categories but have no options of a run.
void AddCategoriesArguments(CLI::App& command, ConfigurationArguments& arguments);

}  // namespace armature
