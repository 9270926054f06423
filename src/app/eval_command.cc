// SPDX-License-Identifier: BSD-3-Clause
#include "app/eval_command.h"

#include <fmt/format.h>

#include <fstream>
#include <map>
#include <memory>

#include "app/printed_tables.h"
#include "eval/evaluation_tables.h"
#include "eval/run_evaluation.h"
#include "io/errors.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

bool HasGroundTruth(const fs::path& folder) {
  return fs::exists(folder / "sequence.yaml") && fs::exists(folder / "objects_gt.csv");
}

// The folders themselves, or the sequences directly inside them.
std::map<std::string, SequenceTruth> LoadGivenTruths(const std::vector<fs::path>& folders) {
  std::map<std::string, SequenceTruth> truths;
  for (const fs::path& folder : folders) {
    std::vector<fs::path> sequences;
    std::error_code absent;
    if (!HasGroundTruth(folder)) {
      for (const auto& entry : fs::directory_iterator(folder, absent)) {
        if (HasGroundTruth(entry.path())) sequences.push_back(entry.path());
      }
    }
    if (sequences.empty()) sequences.push_back(folder);
    for (const fs::path& sequence : sequences) {
      SequenceTruth truth = LoadSequenceTruth(sequence);
      const std::string name = truth.name;
      if (!truths.emplace(name, std::move(truth)).second) {
        throw InputError(fmt::format("{}: a second sequence named '{}'; give one", sequence.string(), name));
      }
    }
  }
  return truths;
}

const SequenceTruth& TruthOf(const RunResults& run, bool is_given,
                             std::map<std::string, SequenceTruth>& truths) {
  if (const auto found = truths.find(run.sequence); found != truths.end()) return found->second;
  if (is_given || run.sequence_folder.empty()) {
    throw InputError(
        fmt::format("{}: is a run of sequence '{}', whose ground truth is not known; give its folder with "
                    "--groundtruth",
                    run.folder.string(), run.sequence));
  }
  return truths.emplace(run.sequence, LoadSequenceTruth(run.sequence_folder)).first->second;
}

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

std::vector<RunResults> LoadRuns(const std::vector<fs::path>& folders) {
  std::vector<RunResults> runs;
  for (const fs::path& folder : folders) {
    for (const fs::path& run : RunsIn(folder)) runs.push_back(LoadRun(run));
  }
  return runs;
}

// By sequence; runs in the order given, named so that they are told apart.
std::map<std::string, std::vector<NamedEvaluation>> EvaluateAll(const EvalArguments& arguments) {
  const std::vector<CategorySpec> specs = SpecsOf(LoadModels(arguments.configuration));
  const CadLibrary cad = arguments.cad.empty() ? CadLibrary() : CadLibrary(arguments.cad, specs);
  const std::vector<RunResults> runs = LoadRuns(arguments.runs);
  std::map<std::string, SequenceTruth> truths = LoadGivenTruths(arguments.ground_truth);
  std::map<std::string, std::vector<NamedEvaluation>> evaluations;
  std::map<std::string, std::vector<fs::path>> folders;
  for (const RunResults& run : runs) {
    const SequenceTruth& truth = TruthOf(run, !arguments.ground_truth.empty(), truths);
    evaluations[run.sequence].push_back({"", EvaluateRun(run, truth, specs, cad)});
    folders[run.sequence].push_back(run.folder);
  }
  for (auto& [sequence, named] : evaluations) {
    const std::vector<std::string> names = RunNames(folders[sequence], sequence);
    for (size_t i = 0; i < named.size(); ++i) named[i].run = names[i];
  }
  return evaluations;
}

}  // namespace

int RunEval(const EvalArguments& arguments) {
  const TableFormat format = arguments.json ? TableFormat::kJson : TableFormatFromName(arguments.format);
  const auto evaluations = EvaluateAll(arguments);
  std::vector<Table> tables;
  std::vector<NamedEvaluation> all;
  for (const auto& [sequence, named] : evaluations) {
    for (Table& table : EvaluationTables(sequence, named)) tables.push_back(std::move(table));
    all.insert(all.end(), named.begin(), named.end());
  }
  if (!arguments.raw.empty()) WriteRaw(arguments.raw, RawCsv(all));
  fmt::print("{}", FormatTables(tables, format));
  return 0;
}

void AddEvalCommand(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<EvalArguments>();
  EvalArguments& a = *arguments;
  CLI::App* eval = app.add_subcommand("eval", "Compare runs with the ground truth of their sequences");
  eval->add_option("RUN", a.runs, "run folders, or folders of run folders")->required()->type_name("DIR");
  eval->add_option("--groundtruth", a.ground_truth,
                   "sequence folders with ground truth, or folders of such (default: where the run says)")
      ->type_name("DIR");
  eval->add_option("--cad", a.cad, "folder of annotated CAD models, to judge matches")->type_name("DIR");
  eval->add_option("--raw", a.raw, "also write a row a detection to this file (CSV)")->type_name("FILE");
  eval->add_option("--format", a.format, "text, markdown, csv, latex or json")->capture_default_str();
  eval->add_flag("--json", a.json, "the same as --format json");
  AddCategoriesArguments(*eval, a.configuration);
  eval->callback([arguments, &exit_status] { exit_status = RunEval(*arguments); });
}

}  // namespace armature
