// SPDX-License-Identifier: BSD-3-Clause
#include "app/completion_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/bash_completion.h"
#include "base/errors.h"
#include "base/nearest_name.h"
#include "cli/help.h"

namespace armature {
namespace {

const std::vector<std::string> kShells = {"bash"};

int PrintCompletion(const CLI::App& program, const std::string& shell) {
  if (std::find(kShells.begin(), kShells.end(), shell) == kShells.end())
    throw InputError("completion: " + UnknownNameMessage("shell", shell, kShells));
  fmt::print("{}", BashCompletion(program));
  return 0;
}

}  // namespace

void AddCompletionCommand(CLI::App& program, int& exit_status) {
  const auto shell = std::make_shared<std::string>();
  CLI::App* completion = program.add_subcommand("completion", "Print a script that completes command lines");
  BeginSection(*completion, "Shell");
  KnownValues(*completion->add_option("SHELL", *shell, "to be completed")->required()->type_name("NAME"),
              kShells);
  Describe(
      *completion,
      {.description = "Prints a script for the shell. Once the shell has read it, the tab key completes "
                      "commands, options, the values that options know, keys for --set, folders and files.",
       .files = {},
       .exit_status = {},
       .examples = {{"for this shell", "source <(armature completion bash)"},
                    {"for all later ones",
                     "armature completion bash >~/.local/share/bash-completion/completions/armature"}}});
  completion->callback([&program, shell, &exit_status] { exit_status = PrintCompletion(program, *shell); });
}

}  // namespace armature
