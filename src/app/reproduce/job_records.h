// SPDX-License-Identifier: BSD-3-Clause
// What became of each job, kept in the folder of results: jobs/<name>.json, and what its calls printed in
// jobs/<name>.log.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/reproduce/job.h"

namespace armature {

std::filesystem::path LogFile(const std::filesystem::path& folder, const std::string& job);

// Throws InputError when it cannot be written.
void WriteRecord(const std::filesystem::path& folder, const JobRecord& record);

// None: it was not finished in this folder, or its record cannot be read.
std::optional<JobRecord> ReadRecord(const std::filesystem::path& folder, const std::string& job);

// "done", "reused", "failed", "not run".
std::string StatusName(JobStatus status);

// Why a job failed: the last line that begins with "armature: " in its log, or how its process ended.
std::string FindReason(const std::filesystem::path& log, int ended);

}  // namespace armature
