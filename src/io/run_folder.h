// SPDX-License-Identifier: BSD-3-Clause
// The folder that a run leaves.
#pragma once

#include <filesystem>

#include "io/output_folder.h"

namespace armature {

// Whether the file is JSON that says `"complete": true`.
bool SaysComplete(const std::filesystem::path& file);

// Whether the folder holds a finished run: a summary.json that says `"complete": true`.
bool IsCompleteRun(const std::filesystem::path& folder);

// Replaces only finished runs.
class RunFolder : public OutputFolder {
 public:
  explicit RunFolder(const std::filesystem::path& folder)
      : OutputFolder(folder, {"a finished run", IsCompleteRun}) {}
};

}  // namespace armature
