// SPDX-License-Identifier: BSD-3-Clause
#include "app/learn_command.h"

#include <fmt/format.h>

#include <memory>

#include "app/learn_report.h"
#include "app/training_models.h"
#include "category/held_out.h"
#include "category/learn.h"
#include "io/annotations.h"
#include "io/category_yaml.h"
#include "io/errors.h"

namespace armature {
namespace {

const std::vector<int> kHeldOutModes = {3, 5, 7, 10, 15};

void CheckArguments(const LearnArguments& arguments) {
  if (arguments.annotations.empty() == arguments.family.empty()) {
    throw InputError("learn: give either --annotations FILE or --family NAME");
  }
  if (arguments.out.empty() && arguments.held_out == 0) {
    throw InputError("learn: nothing to do; give --out FILE, --held-out N, or both");
  }
  if (arguments.count < 2)
    throw InputError(fmt::format("learn: --count {}: at least 2 are needed", arguments.count));
  if (arguments.modes < 0 || arguments.modes > kMaxModes) {
    throw InputError(fmt::format("learn: --modes {}: has to be from 1 to {}", arguments.modes, kMaxModes));
  }
}

}  // namespace

int RunLearn(const LearnArguments& arguments) {
  CheckArguments(arguments);
  TrainingSpec spec = LoadTrainingSpec(arguments.spec);
  if (arguments.modes > 0) spec.modes = arguments.modes;
  const TrainingModels models =
      arguments.family.empty()
          ? AnnotatedTrainingModels(spec, arguments.annotations, arguments.format)
          : FamilyTrainingModels(spec, arguments.family, arguments.count, arguments.seed);
  const std::string source = arguments.source.empty() ? models.source : arguments.source;

  LearnReport report;
  report.models_read = models.read;
  report.model = LearnCategory(spec, models.wireframes, source);
  if (arguments.held_out != 0) {
    report.held_out_every = arguments.held_out;
    report.held_out = HeldOutErrors(spec, models.wireframes, arguments.held_out, kHeldOutModes);
  }
  if (!arguments.out.empty()) {
    WriteCategory(report.model, arguments.out);
    report.out = arguments.out.string();
  }
  fmt::print("{}", arguments.json ? ReportJson(report) : ReportText(report));
  return 0;
}

void AddLearnCommand(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<LearnArguments>();
  LearnArguments& a = *arguments;
  CLI::App* learn =
      app.add_subcommand("learn", "Learn a category model from annotated CAD models or a family");
  learn->add_option("--spec", a.spec, "category specification (configs/categories/specs)")->required();
  learn->add_option("--annotations", a.annotations, "table of annotated models");
  learn
      ->add_option("--format", a.format,
                   fmt::format("format of the annotations: {}", fmt::join(AnnotationFormats(), ", ")))
      ->capture_default_str();
  learn->add_option("--family", a.family, "learn from our own family instead: chair, table or laptop");
  learn->add_option("--count", a.count, "models drawn from the family")->capture_default_str();
  learn->add_option("--seed", a.seed, "seed of the family")->capture_default_str();
  learn->add_option("--modes", a.modes, "size of the basis (default: the specification's)");
  learn->add_option("--held-out", a.held_out,
                    "also leave out every N-th model and report how well it is reconstructed");
  learn->add_option("--source", a.source, "what the models are and their licence, written into the model");
  learn->add_option("--out", a.out, "model file to write");
  learn->add_flag("--json", a.json, "print JSON instead of tables");
  learn->callback([arguments, &exit_status] { exit_status = RunLearn(*arguments); });
}

}  // namespace armature
