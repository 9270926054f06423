// SPDX-License-Identifier: BSD-3-Clause
#include "app/learn/learn_command.h"

#include <fmt/format.h>

#include <memory>

#include "app/learn/learn_report.h"
#include "base/console.h"
#include "base/errors.h"
#include "base/interrupt.h"
#include "category/held_out.h"
#include "category/learn.h"
#include "cli/help.h"
#include "cli/instance_libraries.h"
#include "io/annotations.h"
#include "io/category_yaml.h"
#include "io/library_file.h"
#include "io/training_models.h"

namespace armature {
namespace {

const std::vector<std::string> kFamilies = {"chair", "table", "laptop"};
const std::vector<int> kHeldOutModes = {3, 5, 7, 10, 15};

bool IsComparing(const LearnArguments& arguments) {
  return !arguments.compare.file.empty() || !arguments.compare_family.empty();
}

void CheckArguments(const LearnArguments& arguments) {
  if (arguments.annotations.file.empty() == arguments.family.empty()) {
    throw InputError("learn: give either --annotations FILE or --family NAME");
  }
  if (arguments.annotations.metric && arguments.annotations.file.empty()) {
    throw InputError("learn: --metric is about --annotations; a family is metric already");
  }
  if (!arguments.compare.file.empty() && !arguments.compare_family.empty()) {
    throw InputError("learn: give either --compare FILE or --compare-family NAME");
  }
  if (arguments.annotations.without_kept_apart && arguments.annotations.file.empty()) {
    throw InputError("learn: --without-held-out is about --annotations; of a family nothing is held out");
  }
  if (arguments.out.empty() && arguments.held_out == 0 && !IsComparing(arguments)) {
    throw InputError("learn: nothing to do; give --out FILE, --held-out N or --compare FILE");
  }
  if (!arguments.library.empty() && (arguments.annotations.file.empty() || arguments.out.empty())) {
    throw InputError("learn: --library needs --annotations, in the folder of the CAD models, and --out");
  }
  if (arguments.count < 2)
    throw InputError(fmt::format("learn: --count {}: at least 2 are needed", arguments.count));
  if (arguments.modes < 0 || arguments.modes > kMaxModes) {
    throw InputError(fmt::format("learn: --modes {}: has to be from 1 to {}", arguments.modes, kMaxModes));
  }
}

// How the edges lie in these models, where that differs from the specification.
void SetAnnotationHabits(const LearnArguments& arguments, CategorySpec* spec) {
  if (!arguments.padding.empty())
    spec->padding = {arguments.padding[0], arguments.padding[1], arguments.padding[2]};
  if (!arguments.slab_drop) return;
  if (!spec->slab)
    throw InputError(
        fmt::format("learn: --slab-drop: a {} has no slab; name its edges in the specification", spec->name));
  spec->slab->drop = *arguments.slab_drop;
}

TrainingModels Training(const TrainingSpec& spec, const LearnArguments& arguments,
                        const SampleFamilyFunction& sample_family) {
  if (arguments.family.empty()) return AnnotatedTrainingModels(spec, arguments.annotations);
  const FamilySample sample{arguments.family, arguments.count, arguments.seed};
  return FamilyTrainingModels(spec, sample, sample_family(sample));
}

// The other set; a family is scaled as the models are that it is compared with.
TrainingModels Others(const TrainingSpec& spec, const LearnArguments& arguments,
                      const SampleFamilyFunction& sample_family) {
  if (arguments.compare_family.empty()) return AnnotatedTrainingModels(spec, arguments.compare);
  const bool metric = !arguments.family.empty() || arguments.annotations.metric;
  const FamilySample sample{arguments.compare_family, arguments.count, arguments.seed, metric};
  return FamilyTrainingModels(spec, sample, sample_family(sample));
}

ComparisonReport Compared(const TrainingSpec& spec, const CategoryModel& model,
                          const std::vector<Wireframe>& own, const TrainingModels& others) {
  return {ComputeStatistics(model, spec, own), ComputeStatistics(model, spec, others.wireframes),
          others.source, others.read};
}

void AddInput(CLI::App& learn, LearnArguments& a) {
  BeginSection(learn, "Input");
  learn.add_option("--spec", a.spec, "category specification (configs/categories/specs)")
      ->required()
      ->type_name("FILE");
  learn.add_option("--annotations", a.annotations.file, "table of annotated models")->type_name("FILE");
  KnownValues(*learn.add_option("--format", a.annotations.format, "of the annotations")->type_name("NAME"),
              AnnotationFormats())
      .capture_default_str();
  learn.add_flag("--metric", a.annotations.metric,
                 "the annotations are in metres: keep their sizes instead of scaling each model to the "
                 "category's reference");
  learn.add_flag("--without-held-out", a.annotations.without_kept_apart,
                 "leave out the annotated models that rooms are drawn from: every fifth, by its id "
                 "(datasets/README.md)");
  KnownValues(*learn.add_option("--family", a.family, "learn from our own family instead")->type_name("NAME"),
              kFamilies);
  learn.add_option("--count", a.count, "models drawn from the family")->type_name("N")->capture_default_str();
  learn.add_option("--seed", a.seed, "seed of the family")->type_name("N")->capture_default_str();
}

void AddModel(CLI::App& learn, LearnArguments& a) {
  BeginSection(learn, "Model");
  learn.add_option("--modes", a.modes, "size of the basis (default: the specification's)")->type_name("N");
  learn
      .add_option("--padding", a.padding,
                  "how far the models reach beyond their edges, both sides along each axis, metres")
      ->expected(3)
      ->delimiter(',')
      ->type_name("X,Y,Z");
  learn
      .add_option("--slab-drop", a.slab_drop,
                  "how far below the edges of a top or seat its near sides are seen, metres")
      ->check(CLI::NonNegativeNumber)
      ->type_name("METRES");
  learn.add_option("--source", a.source, "what the models are and their licence, written into the model");
}

void AddJudging(CLI::App& learn, LearnArguments& a) {
  BeginSection(learn, "Judging it");
  learn
      .add_option("--held-out", a.held_out,
                  "also leave out every N-th model and report how well it is reconstructed")
      ->type_name("N");
  learn
      .add_option("--compare", a.compare.file,
                  "also show another table of annotated models, scaled to the category's reference, in the "
                  "learnt modes")
      ->type_name("FILE");
  OfferValues(*learn.add_option("--compare-format", a.compare.format, "its format")->type_name("NAME"),
              AnnotationFormats())
      .capture_default_str();
  OfferValues(*learn
                   .add_option("--compare-family", a.compare_family,
                               "the same with a family of ours (--count, --seed)")
                   ->type_name("NAME"),
              kFamilies);
}

CommandHelp LearnHelp() {
  return {
      .description =
          "Learns what the objects of a category look like: the mean of its edges, their main modes of "
          "deformation and a dictionary of typical shapes, from CAD models whose edges are annotated in a "
          "table (a row an edge, or keypoints), or from one of our own families of furniture. A new category "
          "needs its specification (YAML) and annotations, no code.",
      .files = {{"OUT", "the category model, YAML; name its folder with --categories"},
                {"LIBRARY", "the CAD models with their coefficients, for retrieval"}},
      .exit_status = {},
      .examples = {
          {"chairs from the generated CAD models",
           "armature learn --spec configs/categories/specs/chair.yaml --annotations "
           "datasets/generated/cad/chair_edges.csv --metric --out runs/categories/chair.yaml"},
          {"how well held-out tables of a family are reconstructed, nothing written",
           "armature learn --spec configs/categories/specs/table.yaml --family table --held-out 5"}}};
}

}  // namespace

int RunLearn(const LearnArguments& arguments, const SampleFamilyFunction& sample_family) {
  CheckArguments(arguments);
  TrainingSpec spec = LoadTrainingSpec(arguments.spec);
  if (arguments.modes > 0) spec.modes = arguments.modes;
  SetAnnotationHabits(arguments, &spec.category);
  const TrainingModels models = Training(spec, arguments, sample_family);
  const std::string source = arguments.source.empty() ? models.source : arguments.source;

  LearnReport report;
  report.models_read = models.read;
  report.model = LearnCategory(spec, models.wireframes, source);
  if (arguments.held_out != 0) {
    report.held_out_every = arguments.held_out;
    report.held_out = HeldOutErrors(spec, models.wireframes, arguments.held_out, kHeldOutModes);
  }
  if (IsComparing(arguments)) {
    report.comparison =
        Compared(spec, report.model, models.wireframes, Others(spec, arguments, sample_family));
  }

  ThrowIfInterrupted();
  if (!arguments.out.empty()) {
    WriteCategory(report.model, arguments.out);
    report.out = arguments.out.string();
  }
  if (!arguments.library.empty()) {
    // Of the model as others will read it: written numbers have nine digits.
    const std::filesystem::path folder = std::filesystem::absolute(arguments.annotations.file).parent_path();
    WriteLibrary(BuildFolderLibrary(folder, {LoadCategory(arguments.out)}), arguments.library);
    report.library = arguments.library.string();
  }
  PrintResult(arguments.json ? ReportJson(report) : ReportText(report));
  return 0;
}

void AddLearnCommand(CLI::App& app, const SampleFamilyFunction& sample_family, int& exit_status) {
  const auto arguments = std::make_shared<LearnArguments>();
  LearnArguments& a = *arguments;
  CLI::App* learn =
      app.add_subcommand("learn", "Learn a category model from annotated CAD models or a family");
  Describe(*learn, LearnHelp());
  AddInput(*learn, a);
  AddModel(*learn, a);
  AddJudging(*learn, a);
  BeginSection(*learn, "Output");
  learn->add_option("--out", a.out, "model file to write")->type_name("FILE");
  learn
      ->add_option(
          "--library", a.library,
          "also write a library of the CAD models in the annotations' folder, for `armature retrieve`")
      ->type_name("FILE");
  learn->add_flag("--json", a.json, "print JSON instead of tables");
  learn->callback(
      [arguments, sample_family, &exit_status] { exit_status = RunLearn(*arguments, sample_family); });
}

}  // namespace armature
