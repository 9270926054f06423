// SPDX-License-Identifier: BSD-3-Clause
// Runs jobs, several at once, each when what it needs is there.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "app/reproduce/job.h"
#include "app/reproduce/job_key.h"

namespace armature {

struct JobFolders {
  std::filesystem::path folder;    // where the calls are made and jobs are kept, absolute
  std::filesystem::path finished;  // an older folder of results whose jobs may be used again
  std::filesystem::path program;   // that is called
};

// A record a job, in their order. A job whose outputs are in either folder with the same key is not run
// again; one that fails does not keep others from running that do not need it. At most `at_once` run at a
// time. `on_end` is told of each job when it has ended. Throws Interrupted when the user stops the program:
// what was finished stays and is used by the next call.
std::vector<JobRecord> RunJobs(const std::vector<Job>& jobs, const JobFolders& folders, int at_once,
                               ContentHashes& hashes, const std::function<void(const JobRecord&)>& on_end);

}  // namespace armature
