// SPDX-License-Identifier: BSD-3-Clause
#include "app/reproduce/all_tables.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/reproduce/matrix_tables.h"
#include "base/errors.h"
#include "base/text.h"
#include "cli/printed_tables.h"
#include "io/atomic_write.h"
#include "io/json_file.h"

namespace armature {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kReproduceAgain = "remove it and reproduce again";

// Folders of evaluations and benchmarks that have succeeded.
std::vector<fs::path> FoldersWithTables(const fs::path& folder, const std::vector<JobRecord>& jobs) {
  std::vector<fs::path> folders;
  for (const JobRecord& job : jobs) {
    const bool has_tables = job.name.starts_with("evaluation/") || job.name.starts_with("timings/");
    if (has_tables && job.HasSucceeded()) folders.push_back(folder / job.name);
  }
  return folders;
}

Json MakeTables(const fs::path& folder) {
  const fs::path eval = folder / "eval.json";
  const fs::path file = fs::exists(eval) ? eval : folder / "bench.json";
  const Json json = ReadJsonObject(file, kReproduceAgain);
  if (json.contains("tables") && json["tables"].is_array()) return json["tables"];
  throw InputError(fmt::format("{}: has no list 'tables'; {}", file.string(), kReproduceAgain));
}

std::string FileName(TableFormat format) {
  switch (format) {
    case TableFormat::kText:
      return "tables.txt";
    case TableFormat::kMarkdown:
      return "tables.md";
    case TableFormat::kCsv:
      return "tables.csv";
    case TableFormat::kLatex:
      return "tables.tex";
    case TableFormat::kJson:
      return "tables.json";
  }
  return "";
}

std::string FormatAllJson(const std::vector<Table>& tables, const std::vector<fs::path>& others) {
  Json json = Json::parse(FormatTables(tables, TableFormat::kJson));
  for (const fs::path& other : others) {
    for (const Json& table : MakeTables(other)) json.push_back(table);
  }
  return json.dump(2) + "\n";
}

}  // namespace

std::string FormatAllTables(const std::vector<Table>& tables, const std::vector<fs::path>& others,
                            TableFormat format) {
  if (format == TableFormat::kJson) return FormatAllJson(tables, others);
  std::string text = tables.empty() ? "" : FormatTables(tables, format);
  for (const fs::path& other : others)
    text += (text.empty() ? "" : "\n") + ReadTextFile(other / FileName(format));
  return text;
}

void WriteAllTables(const fs::path& folder, const std::vector<Table>& tables,
                    const std::vector<JobRecord>& jobs) {
  std::vector<Table> own = tables;
  own.push_back(JobTable(jobs));
  const std::vector<fs::path> others = FoldersWithTables(folder, jobs);
  for (const TableFormat format : {TableFormat::kText, TableFormat::kMarkdown, TableFormat::kCsv,
                                   TableFormat::kLatex, TableFormat::kJson})
    AtomicWrite(folder / FileName(format), FormatAllTables(own, others, format));
}

}  // namespace armature
