// SPDX-License-Identifier: BSD-3-Clause
// How `armature bench` hands out what it has measured.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "bench/bench_json.h"
#include "bench/bench_report.h"
#include "bench/environment.h"
#include "io/output_folder.h"
#include "io/text_table.h"

namespace armature {

struct BenchResults {
  BenchEnvironment environment;
  nlohmann::ordered_json settings;  // see BenchJson
  BenchReport report;
};

// All tables below two lines that say where they were measured; as JSON all of bench.json.
std::string BenchText(const BenchResults& results, TableFormat format);

// Replaces only finished benchmarks: a bench.json that says `"complete": true`.
class BenchFolder : public OutputFolder {
 public:
  explicit BenchFolder(const std::filesystem::path& folder);
};

// plots/*.svg, see section_plots.h; `objects`: in the frames of the comparison.
void WritePlots(const BenchReport& report, size_t objects, const BenchFolder& folder);

// bench.json, raw.csv and tables.{txt,md,csv,tex}, then publishes the folder. Throws InputError for a file
// that cannot be written.
void WriteBench(const BenchResults& results, BenchFolder& folder);

}  // namespace armature
