// SPDX-License-Identifier: BSD-3-Clause
// The paper's table of object localization errors (its Table 1), ours beside it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eval/objects/object_tables.h"
#include "io/text_table.h"

namespace armature {

// A row of the paper's table, its numbers as printed.
struct PaperObjectErrors {
  std::string sequence;
  std::string approach;
  int objects = 0;
  std::string best, worst, average;  // metres
};

// results/paper_object_errors.csv. Throws InputError.
std::vector<PaperObjectErrors> ReadPaperObjectErrors(const std::filesystem::path& file);

// The printed numbers as numbers.
std::vector<PaperRecord> MakePaperRecords(const std::vector<PaperObjectErrors>& paper);

// What a reader of the printed numbers should know: averages that cannot be, or are at the edge of what can
// be, and where an approach is worse than the first one of its sequence. A line each.
std::vector<std::string> OddEntries(const std::vector<PaperObjectErrors>& paper);

// The paper's columns. Ours: a row a run and approach, matched by detections where the run's observations
// name objects, so that an object counts however far away it was placed. Then the paper's own rows.
Table PaperTable(const std::vector<SequenceObjects>& sequences, const std::vector<PaperObjectErrors>& paper);

}  // namespace armature
