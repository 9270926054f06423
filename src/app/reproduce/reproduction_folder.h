// SPDX-License-Identifier: BSD-3-Clause
// results/<name>: where a reproduction is made, kept and put in place.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/reproduce/job.h"
#include "app/reproduce/matrix.h"

namespace armature {

// Made in ROOT/<name>.partial, which stays when the work is interrupted so that the next call goes on from
// there, and put at ROOT/<name> when it is done. One program at a time may work on a name.
class ReproductionFolder {
 public:
  // Throws InputError: something else is at ROOT/<name>, another program is at work, the folder cannot be
  // made.
  ReproductionFolder(const std::filesystem::path& root, const std::string& name);
  ~ReproductionFolder();
  ReproductionFolder(const ReproductionFolder&) = delete;
  ReproductionFolder& operator=(const ReproductionFolder&) = delete;

  const std::filesystem::path& partial() const { return partial_; }  // absolute, as the next
  const std::filesystem::path& folder() const { return folder_; }
  const std::filesystem::path& latest() const { return latest_; }

  // Puts the folder in place and lets ROOT/latest point to it. Throws std::runtime_error.
  void Publish();

 private:
  std::filesystem::path folder_, partial_, latest_;
  int lock_ = -1;
};

// environment.json: program, versions, git state, machine, the call, jobs by outcome; `"complete": true`.
// Throws InputError when it cannot be written.
void WriteEnvironment(const std::filesystem::path& folder, double wall_seconds,
                      const std::vector<JobRecord>& jobs);

// pictures/: samples of the data, the maps with their CAD models, plots of the timings; copies.
void CollectPictures(const std::filesystem::path& folder, const Matrix& matrix);

// What each file of the folder is; of those that are there. Name and meaning.
std::vector<std::pair<std::string, std::string>> ListFiles(const std::filesystem::path& folder);

}  // namespace armature
