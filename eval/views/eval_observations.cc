// SPDX-License-Identifier: BSD-3-Clause
#include "eval/views/eval_observations.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/errors.h"
#include "category/category_lookup.h"
#include "cli/help.h"
#include "eval/edges/edge_tables.h"
#include "eval/views/evaluation_tables.h"
#include "eval/views/run_evaluation.h"
#include "io/atomic_write.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

bool Has(const std::vector<std::string>& names, const char* name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void CheckHasEdges(const fs::path& truth_folder, const SequenceTruth& truth) {
  if (truth.edges) return;
  throw InputError(
      fmt::format("{}: has no {} to judge matches by; give the folder of annotated CAD models with --cad",
                  truth_folder.string(), kTrueEdgesFile));
}

// By sequence; runs in the order given. `need_edges`: all sequences have
// to have something to judge matches by.
std::map<std::string, std::vector<NamedEvaluation>> EvaluateAll(const std::vector<RunToEvaluate>& runs,
                                                                const std::vector<CategoryModel>& models,
                                                                const fs::path& cad_folder, bool need_edges) {
  const std::vector<CategorySpec> specs = CollectSpecs(models);
  const CadLibrary cad = cad_folder.empty() ? CadLibrary() : CadLibrary(cad_folder, specs);
  std::map<std::string, SequenceTruth> truths;
  std::map<std::string, std::vector<NamedEvaluation>> evaluations;
  for (const RunToEvaluate& to_evaluate : runs) {
    const RunResults run = LoadRun(to_evaluate.run.folder);
    if (!truths.contains(run.sequence)) truths[run.sequence] = LoadSequenceTruth(to_evaluate.truth, specs);
    const SequenceTruth& truth = truths[run.sequence];
    if (need_edges && cad_folder.empty()) CheckHasEdges(to_evaluate.truth, truth);
    evaluations[run.sequence].push_back({to_evaluate.name, EvaluateRun(run, truth, models, cad)});
  }
  return evaluations;
}

}  // namespace

void AddObservationArguments(CLI::App& command, ObservationArguments& a) {
  BeginSection(command, "Single views");
  command
      .add_option("--cad", a.cad,
                  "folder of annotated CAD models, to judge matches of sequences without edges_gt.csv")
      ->type_name("DIR");
  command.add_option("--raw", a.raw, "also write a row a detection to this file (CSV)")->type_name("FILE");
  command
      .add_option("--raw-edges", a.raw_edges,
                  "also write a row a match of edge and segment to this file (CSV)")
      ->type_name("FILE");
}

Evaluation MakeRunObservationTables(const std::vector<RunToEvaluate>& runs,
                                    const std::vector<CategoryModel>& models,
                                    const std::vector<std::string>& names, bool is_asked,
                                    const ObservationArguments& arguments) {
  const bool asked_edges = is_asked && Has(names, "edges");
  const bool need_edges = asked_edges || !arguments.raw_edges.empty();
  Evaluation made;
  std::vector<NamedEvaluation> all;
  for (const auto& [sequence, named] : EvaluateAll(runs, models, arguments.cad, need_edges)) {
    if (Has(names, "observations"))
      for (Table& table : EvaluationTables(sequence, named)) made.tables.push_back(std::move(table));
    if (asked_edges || (Has(names, "edges") && HaveTrueEdges(named)))
      made.tables.push_back(EdgeTable(sequence, named));
    made.Append({.records = {.views = MakeViewRecords(sequence, named)}});
    all.insert(all.end(), named.begin(), named.end());
  }
  if (!arguments.raw.empty()) AtomicWrite(arguments.raw, RawCsv(all));
  if (!arguments.raw_edges.empty()) AtomicWrite(arguments.raw_edges, RawEdgesCsv(all));
  return made;
}

}  // namespace armature
