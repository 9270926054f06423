// SPDX-License-Identifier: BSD-3-Clause
// All commands of the program.
#pragma once

#include <CLI/CLI.hpp>

namespace armature {

// Adds them, in the order in which they are used and shown, and the options that all have in common. The
// callback of the parsed command runs it and stores its exit status.
void AddCommands(CLI::App& program, int& exit_status);

}  // namespace armature
