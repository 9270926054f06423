// SPDX-License-Identifier: BSD-3-Clause
#include "app/completion_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "cli/help.h"

namespace armature {
namespace {

// Above it the tables _armature_options and _armature_values. COMP_WORDS breaks words at '=' and ':', so the
// line is split anew; what bash has taken for words of their own is cut off the answers.
constexpr const char* kFunction = R"bash(
_armature_answer() {  # KIND OR VALUES, WORD
  local kind=$1 word=$2 before=""
  case "$kind" in
    DIR) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -d -- "$word"); return ;;
    FILE) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -f -- "$word"); return ;;
  esac
  [[ $word == *,* ]] && before="${word%,*},"
  [[ $kind == *= ]] && compopt -o nospace
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "$kind" -- "${word##*,}")
  if [[ $word == *:* && $COMP_WORDBREAKS == *:* ]]; then
    COMPREPLY=("${COMPREPLY[@]#"${word%"${word##*:}"}"}")
  fi
}

_armature() {
  local line=${COMP_LINE:0:COMP_POINT} command="" word option i
  local -a words
  COMPREPLY=()
  read -ra words <<<"$line"
  [[ $line == *[[:space:]] ]] && words+=("")
  for ((i = 1; i < ${#words[@]} - 1; ++i)); do
    [[ ${words[i]} != -* ]] && { command=${words[i]}; break; }
  done
  word=${words[-1]}
  option=${words[-2]}
  if [[ $word == --*=* ]]; then
    option=${word%%=*}
    word=${word#*=}
  elif [[ $word == -* ]]; then
    _armature_answer "${_armature_options[$command ]}" "$word"
    return
  fi
  if [[ $option == -* && -n ${_armature_values[$command $option]} ]]; then
    _armature_answer "${_armature_values[$command $option]}" "$word"
  else
    _armature_answer "${_armature_values[$command ]}" "$word"
  fi
}

complete -F _armature armature
)bash";

// What may follow an option: values, DIR, FILE or, where nobody knows, nothing.
std::string Values(const CLI::Option& option) {
  const std::vector<std::string> known = OfferedValues(option);
  if (!known.empty()) return fmt::format("{}", fmt::join(known, " "));
  const std::string type = FormatType(option);
  if (type == "DIR") return type;
  return type == "FILE" || type == "PATH" ? "FILE" : "";
}

std::string Entry(const std::string& key, const std::string& values) {
  return fmt::format("  [\"{}\"]=\"{}\"\n", key, values);
}

std::vector<std::string> OptionNames(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

// "[run --preset]": what may follow; "[run ]": positional arguments.
std::string ValueEntries(const CLI::App& command) {
  std::string entries;
  for (const CLI::Option* option : command.get_options()) {
    const std::string values = Values(*option);
    if (values.empty()) continue;
    if (option->get_positional()) entries += Entry(command.get_name() + " ", values);
    for (const std::string& name : option->get_lnames())
      entries += Entry(command.get_name() + " --" + name, values);
  }
  return entries;
}

// A script to be sourced by bash 4.4 or later. It completes commands, options, the values that are known
// (also several with commas between), keys of --set, and folders or files for everything else.
std::string BashCompletion(const CLI::App& program) {
  const std::vector<std::string> global = OptionNames(program);
  std::string options = Entry(" ", fmt::format("{}", fmt::join(global, " "))), values;
  std::vector<std::string> commands;
  for (const CLI::App* command : program.get_subcommands({})) {
    commands.push_back(command->get_name());
    std::vector<std::string> names = OptionNames(*command);
    names.insert(names.end(), global.begin(), global.end());
    options += Entry(command->get_name() + " ", fmt::format("{}", fmt::join(names, " ")));
    values += ValueEntries(*command);
  }
  values += Entry(" ", fmt::format("{}", fmt::join(commands, " ")));
  return "# Made by 'armature completion bash'.\ndeclare -gA _armature_options=(\n" + options +
         ")\ndeclare -gA _armature_values=(\n" + values + ")\n" + kFunction;
}

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
