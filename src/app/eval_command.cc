// SPDX-License-Identifier: BSD-3-Clause
#include "app/eval_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <memory>

#include "app/eval_inputs.h"
#include "app/printed_tables.h"
#include "eval/evaluation_tables.h"
#include "eval/run_evaluation.h"
#include "io/errors.h"
#include "io/nearest_name.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

std::vector<CategorySpec> SpecsOf(const std::vector<CategoryModel>& models) {
  std::vector<CategorySpec> specs;
  specs.reserve(models.size());
  for (const CategoryModel& model : models) specs.push_back(model.spec);
  return specs;
}

void WriteRaw(const fs::path& file, const std::string& content) {
  std::ofstream stream(file, std::ios::binary);
  stream << content;
  if (!stream.flush())
    throw InputError(fmt::format("{}: cannot be written; check the folder", file.string()));
}

// By sequence; runs in the order given, named so that they are told apart.
std::map<std::string, std::vector<NamedEvaluation>> EvaluateAll(const EvalArguments& arguments,
                                                                const std::vector<RunToEvaluate>& runs) {
  const std::vector<CategorySpec> specs = SpecsOf(LoadModels(arguments.configuration));
  const CadLibrary cad = arguments.cad.empty() ? CadLibrary() : CadLibrary(arguments.cad, specs);
  std::map<std::string, SequenceTruth> truths;
  std::map<std::string, std::vector<NamedEvaluation>> evaluations;
  std::map<std::string, std::vector<fs::path>> folders;
  for (const auto& [identity, truth_folder] : runs) {
    const RunResults run = LoadRun(identity.folder);
    if (!truths.contains(run.sequence)) truths[run.sequence] = LoadSequenceTruth(truth_folder);
    evaluations[run.sequence].push_back({"", EvaluateRun(run, truths[run.sequence], specs, cad)});
    folders[run.sequence].push_back(run.folder);
  }
  for (auto& [sequence, named] : evaluations) {
    const std::vector<std::string> names = RunNames(folders[sequence], sequence);
    for (size_t i = 0; i < named.size(); ++i) named[i].run = names[i];
  }
  return evaluations;
}

std::vector<Table> ObservationTables(const EvalArguments& arguments, const std::vector<RunToEvaluate>& runs) {
  std::vector<Table> tables;
  std::vector<NamedEvaluation> all;
  for (const auto& [sequence, named] : EvaluateAll(arguments, runs)) {
    for (Table& table : EvaluationTables(sequence, named)) tables.push_back(std::move(table));
    all.insert(all.end(), named.begin(), named.end());
  }
  if (!arguments.raw.empty()) WriteRaw(arguments.raw, RawCsv(all));
  return tables;
}

void CheckTableNames(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (std::find(kTableNames.begin(), kTableNames.end(), name) != kTableNames.end()) continue;
    throw InputError(UnknownNameMessage("table", name, kTableNames));
  }
}

bool IsAsked(const std::string& table, const EvalArguments& arguments) {
  return std::find(arguments.tables.begin(), arguments.tables.end(), table) != arguments.tables.end();
}

// The runs that a kind of tables is made of: all where the user asks for it, where the user does not choose
// those that have what it needs.
std::vector<RunToEvaluate> RunsFor(const std::string& table, const EvalArguments& arguments,
                                   const std::vector<RunToEvaluate>& runs,
                                   const std::function<bool(const RunToEvaluate&)>& has_needed) {
  if (IsAsked(table, arguments)) return runs;
  std::vector<RunToEvaluate> chosen;
  if (arguments.tables.empty())
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(chosen), has_needed);
  return chosen;
}

// The kinds of tables of objects that the user asks for.
std::vector<std::string> AskedObjectTables(const EvalArguments& arguments) {
  std::vector<std::string> names;
  std::copy_if(kObjectTableNames.begin(), kObjectTableNames.end(), std::back_inserter(names),
               [&](const std::string& name) { return IsAsked(name, arguments); });
  return names;
}

// Of all runs where the user asks for some of them; where the user does not choose, all kinds, of the runs
// with the truth that they need.
std::vector<Table> ObjectTables(const EvalArguments& arguments, const std::vector<RunToEvaluate>& runs) {
  const std::vector<std::string> asked = AskedObjectTables(arguments);
  if (asked.empty() && !arguments.tables.empty()) return {};
  std::vector<RunToEvaluate> placed;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(placed), [&](const RunToEvaluate& run) {
    return !asked.empty() || (run.HasTruth("objects_gt.csv") && run.HasTruth("groundtruth.txt"));
  });
  if (placed.empty()) return {};
  ObjectArguments objects = arguments.objects;
  objects.first_n = arguments.trajectories.first_n;
  objects.tolerance = arguments.trajectories.tolerance;
  return ObjectTablesOfRuns(placed, SpecsOf(LoadModels(arguments.configuration)),
                            asked.empty() ? kObjectTableNames : asked, !asked.empty(), objects);
}

std::vector<Table> TablesOfRuns(const EvalArguments& arguments, TableFormat format) {
  const std::vector<RunToEvaluate> runs = FindRuns(arguments.runs, arguments.ground_truth);
  std::vector<Table> tables;
  const auto add = [&](std::vector<Table> more) {
    std::move(more.begin(), more.end(), std::back_inserter(tables));
  };
  const auto observed = RunsFor("observations", arguments, runs,
                                [](const RunToEvaluate& run) { return run.HasTruth("objects_gt.csv"); });
  if (!observed.empty()) add(ObservationTables(arguments, observed));
  const auto moved = RunsFor("trajectory", arguments, runs, [](const RunToEvaluate& run) {
    return run.HasTruth("groundtruth.txt") && run.HasResult("trajectory.txt");
  });
  if (!moved.empty()) add(TrajectoryTablesOfRuns(moved, arguments.trajectories, format));
  add(ObjectTables(arguments, runs));
  if (!tables.empty()) return tables;
  throw InputError(fmt::format(
      "{}: has neither groundtruth.txt nor objects_gt.csv; give the folder of the ground truth with "
      "--groundtruth",
      runs.front().truth.string()));
}

bool AreTrajectoryFiles(const std::vector<fs::path>& runs) {
  return std::all_of(runs.begin(), runs.end(), [](const fs::path& run) { return fs::is_regular_file(run); });
}

std::vector<Table> TablesOfFiles(const EvalArguments& arguments, TableFormat format) {
  const auto& asked = arguments.tables;
  if (!asked.empty() && asked != std::vector<std::string>{"trajectory"}) {
    throw InputError(
        fmt::format("{}: is a trajectory file, which has only the table 'trajectory'; give a run",
                    arguments.runs.front().string()));
  }
  if (!arguments.raw.empty()) throw InputError("--raw: is of detections; use --raw-trajectory with files");
  return TrajectoryTablesOfFiles(arguments.runs, arguments.ground_truth, arguments.trajectories, format);
}

}  // namespace

int RunEval(const EvalArguments& arguments) {
  const TableFormat format = arguments.json ? TableFormat::kJson : TableFormatFromName(arguments.format);
  CheckTableNames(arguments.tables);
  const std::vector<Table> tables =
      AreTrajectoryFiles(arguments.runs) ? TablesOfFiles(arguments, format) : TablesOfRuns(arguments, format);
  fmt::print("{}", FormatTables(tables, format));
  return 0;
}

void AddEvalCommand(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<EvalArguments>();
  EvalArguments& a = *arguments;
  CLI::App* eval = app.add_subcommand("eval", "Compare runs with the ground truth of their sequences");
  eval->add_option("RUN", a.runs, "run folders, or folders of run folders; or trajectory files")
      ->required()
      ->type_name("PATH");
  eval->add_option("--groundtruth", a.ground_truth,
                   "sequence folders with ground truth, or folders of such (default: where the run says); "
                   "for trajectory files: the true one")
      ->type_name("PATH");
  eval->add_option("--tables", a.tables,
                   fmt::format("which tables: {} (default: all that there is truth for)",
                               fmt::join(kTableNames, ", ")))
      ->type_name("NAME")
      ->delimiter(',');
  eval->add_option("--cad", a.cad, "folder of annotated CAD models, to judge matches")->type_name("DIR");
  eval->add_option("--raw", a.raw, "also write a row a detection to this file (CSV)")->type_name("FILE");
  eval->add_option("--format", a.format, "text, markdown, csv, latex or json")->capture_default_str();
  eval->add_flag("--json", a.json, "the same as --format json");
  AddTrajectoryArguments(*eval, a.trajectories);
  AddObjectArguments(*eval, a.objects);
  AddCategoriesArguments(*eval, a.configuration);
  eval->callback([arguments, &exit_status] { exit_status = RunEval(*arguments); });
}

}  // namespace armature
