// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>

#include "app/compare_benches.h"
#include "app/compare_runs.h"
#include "app/printed_tables.h"
#include "eval/compared_values.h"
#include "eval/trajectory_alignment.h"
#include "io/errors.h"
#include "io/run_folder.h"
#include "io/whole_file.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

bool IsBench(const fs::path& folder) { return SaysComplete(folder / "bench.json"); }

void CheckKinds(const std::vector<fs::path>& results) {
  const auto benches = std::count_if(results.begin(), results.end(), IsBench);
  if (benches != 0 && benches != static_cast<std::ptrdiff_t>(results.size()))
    throw InputError("compare: some are benchmarks and some are not; compare runs with runs");
}

Comparison Compare(const CompareArguments& arguments) {
  const fs::path& a = arguments.results.front();
  Comparison all;
  for (size_t i = 1; i < arguments.results.size(); ++i) {
    const fs::path& b = arguments.results[i];
    Comparison one = IsBench(a) ? CompareBenches(a, b) : CompareRuns(a, b, arguments);
    std::move(one.tables.begin(), one.tables.end(), std::back_inserter(all.tables));
    for (const std::string& warning : one.warnings) all.warnings.push_back(b.string() + ": " + warning);
    all.raw += one.raw;
  }
  return all;
}

}  // namespace

int RunCompare(const CompareArguments& arguments) {
  const TableFormat format = arguments.json ? TableFormat::kJson : TableFormatFromName(arguments.format);
  if (arguments.results.size() < 2) throw InputError("compare: give two results or more, the first is A");
  CheckKinds(arguments.results);
  const Comparison comparison = Compare(arguments);
  if (!arguments.raw.empty()) WriteWholeFile(arguments.raw, RawPairColumns() + comparison.raw);
  for (const std::string& warning : comparison.warnings)
    fmt::print(stderr, "armature: warning: {}\n", warning);
  fmt::print("{}", FormatTables(comparison.tables, format));
  return 0;
}

void AddCompareCommand(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<CompareArguments>();
  CompareArguments& a = *arguments;
  CLI::App* compare =
      app.add_subcommand("compare", "Compare runs, or benchmarks, with the first of them: pair by pair");
  compare
      ->add_option("RESULT", a.results,
                   "run folders or folders of run folders, or all folders of 'armature bench --out'")
      ->type_name("DIR")
      ->required();
  compare
      ->add_option("--groundtruth", a.ground_truth,
                   "sequence folders with ground truth, or folders of such (default: where the run says)")
      ->type_name("DIR");
  compare
      ->add_option("--alignment", a.alignment,
                   fmt::format("how cameras and objects are brought to the truth, or B to A without one: {}",
                               fmt::join(AlignmentNames(), ", ")))
      ->type_name("NAME")
      ->capture_default_str();
  compare->add_option("--format", a.format, "text, markdown, csv, latex or json")->capture_default_str();
  compare->add_flag("--json", a.json, "the same as --format json");
  compare->add_option("--raw", a.raw, "also write a row a pair to this file (CSV)")->type_name("FILE");
  AddCategoriesArguments(*compare, a.configuration);
  compare->callback([arguments, &exit_status] { exit_status = RunCompare(*arguments); });
}

}  // namespace armature
