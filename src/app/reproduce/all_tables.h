// SPDX-License-Identifier: BSD-3-Clause
// Every table of a reproduction in one file a format.
#pragma once

#include <filesystem>
#include <vector>

#include "app/reproduce/job.h"
#include "io/text_table.h"

namespace armature {

// The tables, then those of other folders: evaluations and benchmarks. Throws InputError: a file cannot be
// read.
std::string FormatAllTables(const std::vector<Table>& tables,
                            const std::vector<std::filesystem::path>& others, TableFormat format);

// tables.{txt,md,csv,tex,json}: these tables, those of the evaluations and benchmarks in the folder, and what
// became of the jobs. Throws InputError: a file cannot be read or written.
void WriteAllTables(const std::filesystem::path& folder, const std::vector<Table>& tables,
                    const std::vector<JobRecord>& jobs);

}  // namespace armature
