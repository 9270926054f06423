// SPDX-License-Identifier: BSD-3-Clause
// The folder that `armature eval --out` leaves.
#pragma once

#include <filesystem>
#include <vector>

#include "io/output_folder.h"
#include "io/text_table.h"

namespace armature {

// Replaces only finished evaluations: an eval.json that says `"complete": true`.
class EvalFolder : public OutputFolder {
 public:
  explicit EvalFolder(const std::filesystem::path& folder);
};

// eval.json ({"program", "version", "git_commit", "git_dirty", "runs": absolute paths, "tables", "complete"})
// and tables.{txt,md,csv,tex}, then publishes the folder. Throws InputError for a file that cannot be
// written.
void WriteEvaluation(const std::vector<std::filesystem::path>& runs, const std::vector<Table>& tables,
                     EvalFolder& folder);

}  // namespace armature
