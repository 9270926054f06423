// SPDX-License-Identifier: BSD-3-Clause
// `armature completion`: completion for the shell.
#pragma once

#include <CLI/CLI.hpp>

namespace armature {

// Adds the sub-command; once it is parsed, its callback prints the script. It tells of all commands of the
// program, also of those that are added later.
void AddCompletionCommand(CLI::App& program, int& exit_status);

}  // namespace armature
