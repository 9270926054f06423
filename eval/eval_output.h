// SPDX-License-Identifier: BSD-3-Clause
// The folder that `armature eval --out` leaves.
#pragma once

#include <filesystem>
#include <vector>

#include "eval/evaluation.h"
#include "io/output_folder.h"

namespace armature {

// Replaces only finished evaluations: an eval.json that says `"complete": true`.
class EvalFolder : public OutputFolder {
 public:
  explicit EvalFolder(const std::filesystem::path& folder);
};

// eval.json ({"program", "version", "git_commit", "git_dirty", "runs": absolute paths, "tables", "complete"})
// records.json and tables.{txt,md,csv,tex}, then publishes the folder. Throws InputError for a file that
// cannot be written.
void WriteEvaluation(const std::vector<std::filesystem::path>& runs, const Evaluation& evaluation,
                     EvalFolder& folder);

}  // namespace armature
