// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/report_command.h"

#include <fmt/format.h>

#include <iterator>
#include <memory>

#include "base/console.h"
#include "base/errors.h"
#include "base/interrupt.h"
#include "cli/help.h"
#include "cli/printed_tables.h"
#include "eval/eval_command.h"
#include "eval/eval_inputs.h"
#include "eval/report/report_page.h"
#include "eval/report/table_json.h"
#include "io/atomic_write.h"
#include "io/library_file.h"
#include "io/run_folder.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

Evaluation ReadEvaluation(const fs::path& folder) {
  const fs::path file = folder / "eval.json";
  if (!SaysComplete(file))
    throw InputError(fmt::format("{}: is not a finished evaluation; give a folder of `armature eval --out`",
                                 file.string()));
  return {ReadTables(file), ReadEvaluationRecords(folder / "records.json")};
}

// As they were evaluated, or else as `armature eval` does without any choice.
Evaluation CollectEvaluation(const ReportArguments& arguments, const std::vector<RunToEvaluate>& runs) {
  Evaluation all;
  for (const fs::path& folder : arguments.evaluations) all.Append(ReadEvaluation(folder));
  if (!arguments.evaluations.empty()) return all;
  EvalArguments eval;
  eval.configuration = arguments.configuration;
  return MakeRunTables(eval, runs, TableFormat::kText);
}

CommandHelp ReportHelp() {
  return {
      .description =
          "Shows runs, what they were evaluated and timed with, and how, as one HTML page that needs no "
          "network: figures beside the paper's, sortable tables, maps from above, a map in 3D to be turned "
          "with the mouse, frames with their associated edges, retrieved CAD models, and the environment. "
          "What is absent (no truth, no retrieval, no benchmark) is left out and said.",
      .files = {{"OUT", "the page: one file, pictures and scripts in it"}},
      .exit_status = {},
      .examples = {
          {"runs of your own",
           "armature report results/reproduce/runs/objects --categories results/reproduce/categories --out "
           "report.html"},
          {"with retrieval and times that were measured before",
           "armature report results/reproduce/runs/objects --eval results/reproduce/evaluation/accuracy "
           "--eval results/reproduce/evaluation/retrieval --bench results/reproduce/timings/comparison "
           "--library results/reproduce/library.armlib --categories results/reproduce/categories --out "
           "report.html"}}};
}

}  // namespace

ReportSources CollectSources(const ReportArguments& arguments) {
  const std::vector<RunToEvaluate> runs = FindRuns(arguments.runs, arguments.ground_truth);
  ReportSources sources;
  sources.title = arguments.title;
  for (const RunToEvaluate& run : runs) sources.runs.push_back({run.run.folder, run.truth, run.name});
  sources.models = LoadModels(arguments.configuration);
  for (const fs::path& file : arguments.tables) {
    std::vector<Table> tables = ReadTables(file);
    std::move(tables.begin(), tables.end(), std::back_inserter(sources.overview));
  }
  Evaluation evaluation = CollectEvaluation(arguments, runs);
  sources.tables = std::move(evaluation.tables);
  sources.records = std::move(evaluation.records);
  sources.benches = arguments.benches;
  if (!arguments.library.empty()) sources.library = ReadLibrary(arguments.library, sources.models);
  return sources;
}

int RunReport(const ReportArguments& arguments) {
  const ReportData data = CollectReport(CollectSources(arguments));
  ThrowIfInterrupted();
  const std::string page = ReportPage(data);
  AtomicWrite(arguments.out, page);
  for (const std::string& remark : data.remarks) Note(remark);
  PrintResult(fmt::format("{}: the report, {:.1f} MB, opens in any browser without a network\n",
                          arguments.out.string(), static_cast<double>(page.size()) / 1e6));
  return 0;
}

void AddReportCommand(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<ReportArguments>();
  ReportArguments& a = *arguments;
  CLI::App* report =
      app.add_subcommand("report", "Show runs, their evaluation and benchmarks as one HTML page");
  Describe(*report, ReportHelp());
  BeginSection(*report, "What is shown");
  report
      ->add_option("RUN", a.runs,
                   "run folders, or folders of run folders; the first run of each sequence is shown in "
                   "pictures")
      ->required()
      ->type_name("PATH");
  report
      ->add_option("--eval", a.evaluations,
                   "folders of `armature eval --out` on these runs (default: they are evaluated now, without "
                   "retrieval)")
      ->type_name("DIR");
  report->add_option("--bench", a.benches, "folders of `armature bench --out`")->type_name("DIR");
  report
      ->add_option("--table", a.tables,
                   "a table, or several, as a command prints them with --json: shown first")
      ->type_name("FILE.json");
  report
      ->add_option(
          "--library", a.library,
          "library of CAD models that was retrieved from, for pictures of them; see retrieve --build")
      ->type_name("FILE");
  report
      ->add_option("--groundtruth", a.ground_truth,
                   "sequence folders with ground truth, or folders of such (default: where the run says)")
      ->type_name("PATH");
  AddCategoriesArguments(*report, a.configuration);
  BeginSection(*report, "Output");
  report->add_option("--out", a.out, "the page to be written")->required()->type_name("FILE.html");
  report->add_option("--title", a.title, "of the page")->type_name("TEXT")->capture_default_str();
  report->callback([arguments, &exit_status] { exit_status = RunReport(*arguments); });
}

}  // namespace armature
