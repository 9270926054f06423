// SPDX-License-Identifier: BSD-3-Clause
// A folder of results that is complete or absent, never half: written aside and put in place at the end.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace armature {

// Folders that may be overwritten.
struct Replaceable {
  std::string what;  // "a finished run"
  std::function<bool(const std::filesystem::path& folder)> is;
};

// Throws InputError when something is at `folder` that must not be replaced: anything but an empty folder or
// a replaceable one.
void CheckReplaceable(const std::filesystem::path& folder, const Replaceable& replaceable);

// Puts the finished folder `from` at `to` and removes what was there; in one step where the file system can.
// Both are on one file system. Throws std::filesystem::filesystem_error.
void ReplaceFolder(const std::filesystem::path& from, const std::filesystem::path& to);

class OutputFolder {
 public:
  // Creates `folder`.partial-N beside the folder (and the folders around it). What is at `folder` stays as it
  // is until Publish. Throws InputError when something is there that must not be replaced: anything but an
  // empty folder or a replaceable one.
  OutputFolder(const std::filesystem::path& folder, Replaceable replaceable);
  // Removes the partial folder if it was not published.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  // Where to write until Publish.
  const std::filesystem::path& partial() const { return partial_; }
  const std::filesystem::path& folder() const { return folder_; }

  // Puts what was written at `folder`, replacing an older one in one step where the file system can. Throws
  // InputError as the constructor, std::runtime_error when the folder cannot be renamed.
  void Publish();

 private:
  Replaceable replaceable_;
  std::filesystem::path folder_;
  std::filesystem::path partial_;  // empty once published
};

}  // namespace armature
