// SPDX-License-Identifier: BSD-3-Clause
#include "eval/budget/substitute_command.h"

#include <fmt/format.h>

#include <map>
#include <memory>

#include "base/console.h"
#include "base/errors.h"
#include "base/interrupt.h"
#include "base/nearest_name.h"
#include "cli/help.h"
#include "cli/printed_tables.h"
#include "eval/budget/substitution.h"
#include "io/sequence.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

std::vector<SubstitutedTruth> TruthsFromNames(const std::vector<std::string>& names) {
  std::vector<SubstitutedTruth> truths;
  for (const std::string& name : names) {
    const auto truth = FromName<SubstitutedTruth>(name);
    if (!truth)
      throw InputError("--truth: " + UnknownNameMessage("truth", name, ListNames<SubstitutedTruth>()));
    truths.push_back(*truth);
  }
  return truths;
}

// By name. Folders are called by it.
std::map<std::string, fs::path> NameSequences(const std::vector<fs::path>& folders) {
  std::map<std::string, fs::path> sequences;
  for (const fs::path& folder : folders) {
    const std::string name = ReadSequenceSettings(folder / "sequence.yaml").name;
    const auto [other, is_new] = sequences.emplace(name, folder);
    if (is_new) continue;
    throw InputError(fmt::format("{}: has the name '{}' as {} does; give one of them", folder.string(), name,
                                 other->second.string()));
  }
  return sequences;
}

struct PlannedSubstitution {
  fs::path sequence, folder;
  SubstitutedTruth truth;
  SubstitutedFiles files;
};

CommandHelp SubstituteHelp() {
  return {
      .description =
          "Writes sequences in which one thing is replaced by the truth, so that runs on them tell what its "
          "error costs: scale (odometry.txt in metres), cameras (the true ones as odometry), detections (no "
          "false alarms, wrong categories or second boxes of an object), viewpoints (of the detections), "
          "lines (the visible edges of edges_gt.csv and nothing else), identities (as detections, and each "
          "object is a category of its own, so that it is neither missed for another nor merged with it) and "
          "shapes (as identities, and each category's model has its object's size). All other files are "
          "links to those of the sequence.\n\n"
          "A substituted sequence is a sequence like any other and can be substituted again: detections with "
          "true scale. Those of identities and shapes bring their category models: `armature run "
          "--categories "
          "OUT/identities/NAME/categories`. `armature eval --tables error_budget` compares runs on them; "
          "scripts/error_budget.sh does all of it. Results on them say nothing about how good a method is.",
      .files = {{"OUT/TRUTH/NAME/", "a sequence folder of each truth and sequence, complete or absent"},
                {"OUT/TRUTH/NAME/substituted.json", "which sequence it is of and what is true in it"}},
      .exit_status = {},
      .examples = {{"seq1 with the true scale, and again with the true cameras",
                    "armature substitute datasets/generated/seq1 --truth scale,cameras --out runs/truth"}}};
}

}  // namespace

int RunSubstitute(const SubstituteArguments& arguments) {
  const std::vector<SubstitutedTruth> truths = TruthsFromNames(arguments.truths);
  const std::vector<CategoryModel> models = LoadModels(arguments.configuration);
  std::vector<PlannedSubstitution> planned;
  for (const auto& [name, sequence] : NameSequences(arguments.sequences)) {
    for (const SubstitutedTruth truth : truths) {
      ThrowIfInterrupted();
      const fs::path folder = arguments.out / ToName(truth) / name;
      CheckSubstitution(sequence, folder);
      planned.push_back({sequence, folder, truth, SubstituteTruth(sequence, truth, models)});
    }
  }
  for (const PlannedSubstitution& substitution : planned) {
    ThrowIfInterrupted();
    WriteSubstitution(substitution.sequence, substitution.truth, substitution.files, substitution.folder);
    PrintResult(substitution.folder.string() + "\n");
  }
  return 0;
}

void AddSubstituteCommand(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<SubstituteArguments>();
  SubstituteArguments& a = *arguments;
  CLI::App* substitute =
      app.add_subcommand("substitute", "Put a part of the truth into sequences, to see what its error costs");
  Describe(*substitute, SubstituteHelp());
  substitute->add_option("SEQUENCE", a.sequences, "sequence folders with ground truth")
      ->required()
      ->type_name("DIR");
  KnownValues(*substitute->add_option("--truth", a.truths, "what is replaced: a folder of sequences each")
                   ->required()
                   ->type_name("NAME")
                   ->delimiter(','),
              ListNames<SubstitutedTruth>());
  substitute->add_option("--out", a.out, "folder that gets TRUTH/<sequence name> each")
      ->required()
      ->type_name("DIR");
  AddCategoriesArguments(*substitute, a.configuration);
  substitute->callback([arguments, &exit_status] { exit_status = RunSubstitute(*arguments); });
}

}  // namespace armature
