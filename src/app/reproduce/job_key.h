// SPDX-License-Identifier: BSD-3-Clause
// Whether a job that was finished earlier is still right.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "app/reproduce/job.h"

namespace armature {

// Tells contents of files and folders apart; each path is read once.
class ContentHashes {
 public:
  // Of the names below a folder and the bytes of each file. Throws InputError: not there, cannot be read.
  std::string Of(const std::filesystem::path& path);

 private:
  std::map<std::filesystem::path, std::string> known_;
};

// The same for the same program (the bytes of its file, so that also a build from uncommitted changes
// differs), commands and contents of inputs; `folder`: where relative inputs are. Throws InputError as above.
std::string MakeKey(const Job& job, const std::filesystem::path& folder, const std::filesystem::path& program,
                    ContentHashes& hashes);

}  // namespace armature
