// SPDX-License-Identifier: BSD-3-Clause
// A result folder that is complete or absent, never half: written aside and put in place at the end.
#pragma once

#include <filesystem>

namespace armature {

// Whether the folder holds a finished run: a summary.json that says `"complete": true`.
bool IsCompleteRun(const std::filesystem::path& folder);

class RunFolder {
 public:
  // Creates `folder`.partial-N beside the folder (and the folders around it). What is at `folder` stays as it
  // is until Publish. Throws InputError when something is there that a run must not replace: anything but an
  // empty folder or a finished run.
  explicit RunFolder(const std::filesystem::path& folder);
  // Removes the partial folder if it was not published.
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  // Where to write until Publish.
  const std::filesystem::path& partial() const { return partial_; }
  const std::filesystem::path& folder() const { return folder_; }

  // Puts what was written at `folder`, replacing an older run in one step where the file system can. Throws
  // InputError as the constructor, std::runtime_error when the folder cannot be renamed.
  void Publish();

 private:
  std::filesystem::path folder_;
  std::filesystem::path partial_;  // empty once published
};

}  // namespace armature
