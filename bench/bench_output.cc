// SPDX-License-Identifier: BSD-3-Clause
#include "bench/bench_output.h"

#include <fmt/format.h>

#include "bench/sections/section_plots.h"
#include "cli/printed_tables.h"
#include "io/atomic_write.h"
#include "io/run_folder.h"

namespace armature {
namespace {

// What makes a line a comment, or a paragraph of its own.
std::pair<std::string, std::string> LineFrame(TableFormat format) {
  if (format == TableFormat::kCsv) return {"# ", "\n"};
  if (format == TableFormat::kLatex) return {"% ", "\n"};
  return {"", format == TableFormat::kMarkdown ? "\n\n" : "\n"};
}

bool IsCompleteBench(const std::filesystem::path& folder) { return SaysComplete(folder / "bench.json"); }

}  // namespace

std::string BenchText(const BenchResults& results, TableFormat format) {
  if (format == TableFormat::kJson) return BenchJson(results.environment, results.settings, results.report);
  const auto [before, after] = LineFrame(format);
  std::string text;
  for (const std::string& line : EnvironmentLines(results.environment))
    text.append(before).append(line).append(after);
  if (format != TableFormat::kMarkdown) text += "\n";
  std::vector<Table> tables;
  for (const BenchSection& section : results.report.sections)
    tables.insert(tables.end(), section.tables.begin(), section.tables.end());
  return text + FormatTables(tables, format);
}

BenchFolder::BenchFolder(const std::filesystem::path& folder)
    : OutputFolder(folder, {"a finished benchmark", IsCompleteBench}) {}

void WritePlots(const BenchReport& report, size_t objects, const BenchFolder& folder) {
  const std::filesystem::path plots = folder.partial() / "plots";
  std::filesystem::create_directory(plots);
  for (const BenchSection& section : report.sections) WriteSectionPlots(section, objects, plots);
}

void WriteBench(const BenchResults& results, BenchFolder& folder) {
  const std::filesystem::path& to = folder.partial();
  AtomicWrite(to / "bench.json", BenchText(results, TableFormat::kJson));
  AtomicWrite(to / "raw.csv", RawCsv(results.report));
  WriteTableFiles(to, [&](TableFormat format) { return BenchText(results, format); });
  folder.Publish();
}

}  // namespace armature
