// SPDX-License-Identifier: BSD-3-Clause
// What a call of `armature bench` measures, checked before the first clock starts.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "bench/bench_arguments.h"
#include "bench/bench_report.h"
#include "bench/guard/guarded_spans.h"
#include "bench/micro/micro_benchmark.h"
#include "bench/sections/bench_task.h"
#include "bench/sections/retrieval_section.h"
#include "io/sequence.h"

namespace armature {

struct BenchPlan {
  std::vector<std::string> tables;  // each once
  size_t frames = 0;                // of each sequence, at most; 0: all
  std::filesystem::path cad;
  EngineParts parts;
  BenchSettings settings;
  std::vector<Sequence> sequences;  // without pixels; none where no table needs one
  MicroSetup micro_setup;
  std::vector<MicroBenchmark> micro;  // chosen; they point to the set-up
  RetrievalSetup retrieval;

  // Reads what is small. Throws InputError for whatever would be found out later otherwise.
  explicit BenchPlan(const BenchArguments& arguments);
  BenchPlan(const BenchPlan&) = delete;
  BenchPlan& operator=(const BenchPlan&) = delete;

  bool Has(const std::string& table) const;
};

// What the report will have sections of.
std::set<TableOfSequence> ListTablesOfSequences(const BenchPlan& plan);

// Memory first, in processes of their own, then the images are loaded; the sections are in the order of
// sequences and tables, those without a sequence last.
BenchReport Measure(const BenchPlan& plan);

}  // namespace armature
