// SPDX-License-Identifier: BSD-3-Clause
#include "app/generate_command.h"

#include <fmt/format.h>

#include <memory>

#include "datasets/sample.h"
#include "io/errors.h"

namespace armature {

int RunGenerate(const GenerateArguments& arguments) {
  if (!arguments.sample) throw InputError("generate: say what to draw: --sample");
  WriteSample(arguments.out, {.frames = arguments.frames, .seed = arguments.seed});
  fmt::print("Sample sequence with ground truth: {}\n", arguments.out.string());
  return 0;
}

void AddGenerateCommand(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<GenerateArguments>();
  GenerateArguments& a = *arguments;
  CLI::App* generate = app.add_subcommand("generate", "Draw the embedded data");
  generate->add_flag("--sample", a.sample, "the sample: a room with three chairs, a table and a laptop");
  generate->add_option("--out", a.out, "sequence folder to write")->required()->type_name("DIR");
  generate->add_option("--frames", a.frames, "only the first N images")
      ->check(CLI::Range(1, 24))
      ->type_name("N")
      ->capture_default_str();
  generate->add_option("--seed", a.seed, "of the noise")->capture_default_str();
  generate->callback([arguments, &exit_status] { exit_status = RunGenerate(*arguments); });
}

}  // namespace armature
