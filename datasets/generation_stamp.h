// SPDX-License-Identifier: BSD-3-Clause
// Tells what a generated folder was made from, so that it is made once and used again.
#pragma once

#include <filesystem>
#include <string>

#include "io/output_folder.h"

namespace armature {

// Raised whenever the same scene or collection gives other files.
constexpr int kGeneratorVersion = 1;

// The content of generated.json. `what`: everything that the files depend on, beside the version; it is kept
// as a hash.
std::string GenerationStamp(const std::string& what);

void WriteStamp(const std::filesystem::path& folder, const std::string& stamp);

// Whether the folder was made with this stamp, completely.
bool HasStamp(const std::filesystem::path& folder, const std::string& stamp);

// Folders that some version of the generator has made.
Replaceable GeneratedFolders();

}  // namespace armature
