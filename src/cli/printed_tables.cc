// SPDX-License-Identifier: BSD-3-Clause
#include "cli/printed_tables.h"

#include <nlohmann/json.hpp>

#include "cli/help.h"
#include "io/atomic_write.h"

namespace armature {

std::string FormatTables(const std::vector<Table>& tables, TableFormat format) {
  if (format == TableFormat::kJson) {
    auto array = nlohmann::ordered_json::array();
    for (const Table& table : tables)
      array.push_back(nlohmann::ordered_json::parse(FormatTable(table, format)));
    return array.dump(2) + "\n";
  }
  std::string text;
  for (const Table& table : tables) {
    if (!text.empty()) text += "\n";
    text += FormatTable(table, format);
  }
  return text;
}

void WriteTableFiles(const std::filesystem::path& folder,
                     const std::function<std::string(TableFormat)>& text) {
  AtomicWrite(folder / "tables.txt", text(TableFormat::kText));
  AtomicWrite(folder / "tables.md", text(TableFormat::kMarkdown));
  AtomicWrite(folder / "tables.csv", text(TableFormat::kCsv));
  AtomicWrite(folder / "tables.tex", text(TableFormat::kLatex));
}

void AddFormatArguments(CLI::App& command, std::string& format, bool& json) {
  KnownValues(*command.add_option("--format", format, "how tables are printed")->type_name("NAME"),
              TableFormatNames())
      .capture_default_str();
  command.add_flag("--json", json, "the same as --format json");
}

void AddCategoriesArguments(CLI::App& command, ConfigurationArguments& arguments) {
  BeginSection(command, "Configuration");
  command.add_option("--categories", arguments.categories, "folder of category models (CONFIGS/categories)")
      ->type_name("DIR");
  command.add_option("--configs", arguments.configs, "CONFIGS: folder of presets and categories")
      ->type_name("DIR");
}

}  // namespace armature
