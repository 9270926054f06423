// SPDX-License-Identifier: BSD-3-Clause
#include "eval/objects/eval_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/console.h"
#include "base/errors.h"
#include "category/category_lookup.h"
#include "cli/data_folders.h"
#include "cli/help.h"
#include "eval/objects/normal_term_table.h"
#include "eval/objects/object_tables.h"
#include "eval/objects/paper_object_errors.h"
#include "eval/views/evaluation_tables.h"
#include "io/atomic_write.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

// The objects of a sequence's runs, and the single observations of the same runs in the same order.
struct EvaluatedSequence {
  SequenceObjects objects;
  std::vector<NamedEvaluation> observations;

  bool HasMap() const {
    return std::any_of(objects.runs.begin(), objects.runs.end(),
                       [](const NamedObjects& run) { return !run.objects.maps.empty(); });
  }
};

EvaluatedSequence EvaluateSequence(const std::vector<RunToEvaluate>& runs,
                                   const std::vector<CategoryModel>& models,
                                   const ObjectEvaluationOptions& options) {
  const std::vector<CategorySpec> specs = CollectSpecs(models);
  const SequenceTruth truth = LoadSequenceTruth(runs.front().truth, specs);
  EvaluatedSequence evaluated{{truth.name, truth.truth.objects_source, options, {}}, {}};
  for (const RunToEvaluate& to_evaluate : runs) {
    const RunResults run = LoadRun(to_evaluate.run.folder);
    evaluated.objects.runs.push_back({to_evaluate.name, EvaluateRunObjects(run, truth, specs, options)});
    evaluated.observations.push_back({to_evaluate.name, EvaluateRun(run, truth, models, CadLibrary())});
  }
  return evaluated;
}

// By name.
std::vector<EvaluatedSequence> EvaluateSequences(const std::vector<RunToEvaluate>& runs,
                                                 const std::vector<CategoryModel>& models,
                                                 const ObjectEvaluationOptions& options, bool is_asked) {
  std::map<std::string, std::vector<RunToEvaluate>> runs_of;
  for (const RunToEvaluate& run : runs) runs_of[run.run.sequence].push_back(run);
  std::vector<EvaluatedSequence> sequences;
  for (const auto& [name, its_runs] : runs_of) {
    EvaluatedSequence sequence = EvaluateSequence(its_runs, models, options);
    if (sequence.HasMap() || is_asked) {
      sequences.push_back(std::move(sequence));
    } else {
      Note(fmt::format("no tables of the objects of {}: no run on it has an objects.csv", name));
    }
  }
  return sequences;
}

// Without the source's file there are only our own rows.
std::vector<PaperObjectErrors> PaperNumbers(const fs::path& named) {
  const fs::path file = named.empty() ? ResultsFolder() / "paper_object_errors.csv" : named;
  if (named.empty() && !fs::exists(file)) return {};
  return ReadPaperObjectErrors(file);
}

void WriteRawObjects(const fs::path& file, const std::vector<SequenceObjects>& sequences) {
  if (file.empty()) return;
  AtomicWrite(file, RawObjectsCsv(sequences));
}

}  // namespace

ObjectEvaluationOptions MakeObjectOptions(const ObjectArguments& arguments) {
  if (!(arguments.gate_m > 0))
    throw InputError(fmt::format("--gate {:g}: give metres, more than 0", arguments.gate_m));
  return {AlignmentFromName(arguments.alignment), arguments.first_n, arguments.tolerance, arguments.gate_m};
}

void AddObjectArguments(CLI::App& command, ObjectArguments& a) {
  BeginSection(command, "Objects");
  OfferValues(*command
                   .add_option("--object-alignment", a.alignment,
                               "how maps are brought to the truth before objects are compared: one of those "
                               "of --alignment")
                   ->type_name("NAME"),
              AlignmentNames())
      .capture_default_str();
  command
      .add_option("--gate", a.gate_m, "metres between an object and the true one it is matched to, at most")
      ->capture_default_str();
  command
      .add_option("--paper-numbers", a.paper,
                  "the paper's object errors, shown below ours (default: results/paper_object_errors.csv)")
      ->type_name("FILE");
  command.add_option("--raw-objects", a.raw, "also write a row an object to this file (CSV)")
      ->type_name("FILE");
}

Evaluation MakeRunObjectTables(const std::vector<RunToEvaluate>& runs,
                               const std::vector<CategoryModel>& models,
                               const std::vector<std::string>& names, bool is_asked,
                               const ObjectArguments& arguments) {
  const auto has = [&](const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  Evaluation made;
  std::vector<SequenceObjects> all;
  for (const auto& [objects, observations] :
       EvaluateSequences(runs, models, MakeObjectOptions(arguments), is_asked)) {
    if (has("objects")) made.tables.push_back(ObjectSummaryTable(objects));
    if (has("each_object")) made.tables.push_back(EachObjectTable(objects));
    if (has("normal")) made.tables.push_back(NormalTermTable(objects, observations));
    made.Append({.records = {.objects = MakeObjectRecords(objects),
                             .uprightness = MakeUprightnessRecords(objects, observations)}});
    all.push_back(objects);
  }
  if (has("paper") && !all.empty()) {
    const std::vector<PaperObjectErrors> paper = PaperNumbers(arguments.paper);
    made.tables.push_back(PaperTable(all, paper));
    made.records.paper = MakePaperRecords(paper);
  }
  WriteRawObjects(arguments.raw, all);
  return made;
}

}  // namespace armature
