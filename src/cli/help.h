// SPDX-License-Identifier: BSD-3-Clause
// What `armature COMMAND --help` says, and which values the shell offers. A new command:
//
// clang-format off
//   CLI::App* fold = app.add_subcommand("fold", "Fold paper into furniture");  // its line in `armature --help`
//   Describe(*fold, {.description = "Takes ... and writes ...",
//                    .files = {{"OUT/chair.ply", "the mesh"}},
//                    .examples = {{"a chair of brown paper", "armature fold --paper brown --out runs/folded"}}});
//   BeginSection(*fold, "What is folded");  // heads the options that follow
//   KnownValues(*fold->add_option("--paper", ...)->type_name("NAME"), {"white", "brown"});
// clang-format on
//
// The type name says what the shell offers for an option without known values: folders for DIR, files for
// FILE and PATH. A test parses the examples; they are for the root of the sources, after scripts/run.sh.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace armature {

struct HelpEntry {
  std::string name, meaning;
};

struct HelpExample {
  std::string purpose;
  std::string line;  // "armature run ..."
};

struct CommandHelp {
  std::string description;             // wrapped when it is shown; an empty line between paragraphs
  std::vector<HelpEntry> files;        // that the command writes
  std::vector<HelpEntry> exit_status;  // {"1", ...}: what it means beyond what is common to all commands
  std::vector<HelpExample> examples;   // at least one
};

// Sets what --help shows. The command's footer, if it has one, comes last.
void Describe(CLI::App& command, CommandHelp help);

// The same for the program itself: its commands in the order they were added, and its options.
void DescribeProgram(CLI::App& program);

// Options that are added from now on are shown under this heading.
void BeginSection(CLI::App& command, const std::string& heading);

// Values that the shell offers. They are not checked: the command tells unknown ones itself, with the nearest
// that is known.
CLI::Option& OfferValues(CLI::Option& option, const std::vector<std::string>& values);
std::vector<std::string> OfferedValues(const CLI::Option& option);

// The same for values that are few enough to be named in the help, too.
CLI::Option& KnownValues(CLI::Option& option, const std::vector<std::string>& values);

// Its type name alone: "DIR"; empty for a flag.
std::string FormatType(const CLI::Option& option);

}  // namespace armature
