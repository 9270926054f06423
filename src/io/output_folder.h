// SPDX-License-Identifier: BSD-3-Clause
// A folder of results that is complete or absent, never half: written aside and put in place at the end.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "base/child_process.h"

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

// Whether the name is one of those under which folders are written aside: they are no results, though they
// may look like some when a program was killed.
bool IsPartial(const std::filesystem::path& folder);

class OutputFolder {
 public:
  // Creates `folder`.partial-N beside the folder (and the folders around it), and removes those that programs
  // which were killed have left there. What is at `folder` stays as it is until Publish. Throws InputError
  // when something is there that must not be replaced: anything but an empty folder or a replaceable one.
  OutputFolder(const std::filesystem::path& folder, Replaceable replaceable);
  // Removes the partial folder if it was not published.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  // Where to write until Publish.
  const std::filesystem::path& partial() const { return partial_; }
  const std::filesystem::path& folder() const { return folder_; }

  // Takes over all files that are in `folder` now: by their names alone, so that they take no space. They are
  // not to be changed, but may be replaced (AtomicWrite). Throws InputError.
  void TakeOver() const;

  // Sees to it that what was written is on the disk, and puts it at `folder`, replacing an older one in one
  // step where the file system can. Throws InputError as the constructor, and when it cannot be done.
  void Publish();

 private:
  Replaceable replaceable_;
  std::filesystem::path folder_;
  std::filesystem::path partial_;  // empty once published
  FileDescriptor lock_{-1};        // of the partial folder: its program lives
};

}  // namespace armature
