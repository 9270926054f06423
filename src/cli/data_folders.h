// SPDX-License-Identifier: BSD-3-Clause
// Where the files are that come with the program: beside an installed program (PREFIX/bin/armature has them
// in PREFIX/share/armature, wherever PREFIX was moved to), else in the source tree that it was built from.
#pragma once

#include <filesystem>

namespace armature {

// Presets, categories, ablations: the folder that the user named, that of the environment's ARMATURE_CONFIGS,
// or the program's own.
std::filesystem::path ConfigsFolder(const std::filesystem::path& named);

// Specifications of the scenes to generate.
std::filesystem::path ScenesFolder();

// Results that are kept: the paper's tables.
std::filesystem::path ResultsFolder();

}  // namespace armature
