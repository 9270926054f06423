// SPDX-License-Identifier: BSD-3-Clause
// Collects what a report shows from the folders that other commands have left.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "eval/report/report_data.h"
#include "io/evaluation_records.h"
#include "io/text_table.h"
#include "retrieval/instance_library.h"

namespace armature {

struct ReportSources {
  std::string title = "Armature";
  // Run folders with the sequence folder of each (images, truth); the first run of a sequence is the one
  // whose overlays, retrieval and 3D view are shown.
  struct Run {
    std::filesystem::path folder, sequence;
    std::string name;  // as the tables have it
  };
  std::vector<Run> runs;
  std::vector<Table> tables;                   // of an evaluation of these runs, to be shown
  EvaluationRecords records;                   // of the same, to be computed with
  std::vector<Table> overview;                 // others, shown first
  std::vector<std::filesystem::path> benches;  // folders of `armature bench --out`
  InstanceLibrary library;                     // the surfaces of retrieved models; of no category: none
  std::vector<CategoryModel> models;
};

// Throws InputError: a missing or malformed file. What is absent (no truth, no retrieval.csv, no benchmark,
// images that are gone) leaves its part empty, and a remark says so where a reader would miss it.
ReportData CollectReport(const ReportSources& sources);

}  // namespace armature
