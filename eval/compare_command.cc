// SPDX-License-Identifier: BSD-3-Clause
#include "eval/compare_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>

#include "base/console.h"
#include "base/errors.h"
#include "cli/compared_values.h"
#include "cli/help.h"
#include "cli/printed_tables.h"
#include "eval/compare_runs.h"
#include "eval/trajectories/trajectory_alignment.h"
#include "io/atomic_write.h"
#include "io/run_folder.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

bool IsBench(const fs::path& folder) { return SaysComplete(folder / "bench.json"); }

void CheckKinds(const std::vector<fs::path>& results) {
  const auto benches = std::count_if(results.begin(), results.end(), IsBench);
  if (benches != 0 && benches != static_cast<std::ptrdiff_t>(results.size()))
    throw InputError("compare: some are benchmarks and some are not; compare runs with runs");
}

Comparison Compare(const CompareArguments& arguments, const CompareFolders& compare_benches) {
  const fs::path& a = arguments.results.front();
  Comparison all;
  for (size_t i = 1; i < arguments.results.size(); ++i) {
    const fs::path& b = arguments.results[i];
    Comparison one = IsBench(a) ? compare_benches(a, b) : CompareRuns(a, b, arguments);
    std::move(one.tables.begin(), one.tables.end(), std::back_inserter(all.tables));
    for (const std::string& warning : one.warnings) all.warnings.push_back(b.string() + ": " + warning);
    all.raw += one.raw;
  }
  return all;
}

CommandHelp CompareHelp() {
  return {
      .description =
          "Puts results side by side with the first of them, A: errors and times are paired by frame, "
          "detection and object where the inputs agree, and the median difference is given with its 95 % "
          "interval and a mark where that leaves out zero. Warns where a pairing says little: other data, "
          "another machine, other models. Runs without ground truth are compared with each other.",
      .files = {{"RAW", "with --raw: a row a pair"}},
      .exit_status = {},
      .examples = {
          {"two ways of running the same sequences, paired",
           "armature compare results/reproduce/runs/objects results/reproduce/runs/fast --categories "
           "results/reproduce/categories"},
          {"two benchmarks, as Markdown", "armature compare runs/bench_a runs/bench_b --format markdown"}}};
}

}  // namespace

int RunCompare(const CompareArguments& arguments, const CompareFolders& compare_benches) {
  const TableFormat format = arguments.json ? TableFormat::kJson : TableFormatFromName(arguments.format);
  if (arguments.results.size() < 2) throw InputError("compare: give two results or more, the first is A");
  CheckKinds(arguments.results);
  const Comparison comparison = Compare(arguments, compare_benches);
  if (!arguments.raw.empty()) AtomicWrite(arguments.raw, RawPairColumns() + comparison.raw);
  for (const std::string& warning : comparison.warnings) Note("warning: " + warning);
  fmt::print("{}", FormatTables(comparison.tables, format));
  return 0;
}

void AddCompareCommand(CLI::App& app, const CompareFolders& compare_benches, int& exit_status) {
  const auto arguments = std::make_shared<CompareArguments>();
  CompareArguments& a = *arguments;
  CLI::App* compare =
      app.add_subcommand("compare", "Compare runs, or benchmarks, with the first of them: pair by pair");
  Describe(*compare, CompareHelp());
  BeginSection(*compare, "What is compared");
  compare
      ->add_option("RESULT", a.results,
                   "run folders or folders of run folders, or all folders of 'armature bench --out'")
      ->type_name("DIR")
      ->required();
  compare
      ->add_option("--groundtruth", a.ground_truth,
                   "sequence folders with ground truth, or folders of such (default: where the run says)")
      ->type_name("DIR");
  KnownValues(*compare
                   ->add_option("--alignment", a.alignment,
                                "how cameras and objects are brought to the truth, or B to A without one")
                   ->type_name("NAME")
                   ->capture_default_str(),
              AlignmentNames());
  AddCategoriesArguments(*compare, a.configuration);
  BeginSection(*compare, "Output");
  AddFormatArguments(*compare, a.format, a.json);
  compare->add_option("--raw", a.raw, "also write a row a pair to this file (CSV)")->type_name("FILE");
  compare->callback(
      [arguments, compare_benches, &exit_status] { exit_status = RunCompare(*arguments, compare_benches); });
}

}  // namespace armature
