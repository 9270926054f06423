// SPDX-License-Identifier: BSD-3-Clause
// A piece of work of `armature reproduce`: calls of this program, what they read, and what they leave.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace armature {

// Paths in commands and outputs are relative to the folder of results, where the calls are made.
struct Job {
  std::string name{};                                // "runs/objects/seq1"
  std::vector<std::vector<std::string>> commands{};  // arguments of the program, call after call
  std::vector<std::string> outputs{};                // files and folders
  // Files and folders whose content decides, with commands and program, whether the outputs are still right.
  std::vector<std::filesystem::path> inputs{};
  std::vector<std::string> after{};  // jobs that have to be done before
  bool alone = false;                // nothing may run beside it: it uses all cores, or is timed
  // Looks by itself whether its outputs are there: its data is shared by several folders of results.
  bool always = false;
};

enum class JobStatus { kDone, kReused, kFailed, kNotRun };

// What became of it, kept beside the results.
struct JobRecord {
  std::string name{};
  JobStatus status = JobStatus::kNotRun;
  double seconds = 0;                   // that its calls took, when they were made
  std::string key{};                    // see job_key.h; empty: it did not succeed
  std::string reason{};                 // one line: why it failed or was not run
  std::vector<std::string> commands{};  // as they can be typed in the folder of results

  bool HasSucceeded() const { return status == JobStatus::kDone || status == JobStatus::kReused; }
};

}  // namespace armature
