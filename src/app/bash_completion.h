// SPDX-License-Identifier: BSD-3-Clause
// Completion in bash, generated from the program's own options, so that it cannot drift from them.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace armature {

// A script to be sourced by bash 4.4 or later. It completes commands, options, the values that are known
// (also several with commas between), keys of --set, and folders or files for everything else.
std::string BashCompletion(const CLI::App& program);

}  // namespace armature
