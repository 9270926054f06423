// SPDX-License-Identifier: BSD-3-Clause
#include "bench/bench_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <opencv2/core.hpp>

#include "base/errors.h"
#include "base/progress.h"
#include "bench/bench_sequence.h"
#include "bench/micro/micro_benchmarks.h"
#include "bench/sections/bench_tables.h"
#include "bench/sections/comparison_section.h"
#include "bench/sections/memory_section.h"
#include "bench/sections/pipelined_section.h"
#include "category/category_lookup.h"

namespace armature {
namespace {

void CheckAtLeast(const char* option, int value, int least) {
  if (value < least) throw InputError(fmt::format("{} {}: has to be {} or more", option, value, least));
}

void CheckBenchArguments(const BenchArguments& a) {
  CheckAtLeast("--frames", a.frames, 0);
  CheckAtLeast("--warm-up", a.warm_up, 0);
  CheckAtLeast("--repeat", a.repeat, 1);
  CheckAtLeast("--threads", a.threads, 1);
  CheckAtLeast("--objects", a.objects, 1);
  CheckAtLeast("--baseline-frames", a.baseline_frames, 1);
  for (const std::string& table : a.tables) CheckBenchTableName(table);
}

// Each name once, where it is first.
std::vector<std::string> EachOnce(const std::vector<std::string>& names) {
  std::vector<std::string> once;
  for (const std::string& name : names) {
    if (std::find(once.begin(), once.end(), name) == once.end()) once.push_back(name);
  }
  return once;
}

EngineParts MakeParts(const ConfigurationArguments& configuration) {
  return {LoadOptions(configuration), LoadPresets(configuration), LoadModels(configuration)};
}

BenchSettings MakeSettings(const BenchArguments& a, const EngineParts& parts) {
  BenchSettings settings;
  settings.harness = {static_cast<size_t>(a.warm_up), static_cast<size_t>(a.repeat)};
  settings.threads = a.threads;
  settings.objects = static_cast<size_t>(a.objects);
  settings.baseline_frames = static_cast<size_t>(a.baseline_frames);
  for (const std::string& name : a.engines.empty() ? DefaultEngines() : a.engines)
    settings.engines.push_back(FullEngineName(name, parts));
  settings.engines = EachOnce(settings.engines);
  return settings;
}

// The tables that were chosen, or all that these engines can fill: one compares our pipeline's threads.
std::vector<std::string> MakeTables(const BenchArguments& a, const std::vector<std::string>& engines) {
  std::vector<std::string> tables = EachOnce(a.tables.empty() ? BenchTableNames() : a.tables);
  if (std::any_of(engines.begin(), engines.end(), IsLinesEngine)) return tables;
  const auto pipelined = std::find(tables.begin(), tables.end(), kPipelinedTable);
  if (pipelined == tables.end()) return tables;
  if (!a.tables.empty())
    throw InputError("--tables pipelined: needs an engine that is our pipeline; add --engines lines");
  tables.erase(pipelined);
  return tables;
}

MicroSetup MakeMicroSetup(const EngineParts& parts) {
  return {
      .models = parts.models, .association = parts.options.association, .resection = parts.options.resection};
}

// Engines race on its frames.
bool IsRace(const std::string& table) { return table != kMemoryTable && NeedsSequence(table); }

void CheckFrames(const Sequence& sequence, const BenchPlan& plan) {
  CheckHasObjects(sequence, plan.frames);
  std::vector<size_t> objects;
  for (const auto& detections : sequence.detections) objects.push_back(detections.size());
  if (plan.frames > 0) objects.resize(std::min(plan.frames, objects.size()));
  if (std::any_of(plan.tables.begin(), plan.tables.end(), IsRace))
    CheckLongerThanWarmUp(objects.size(), plan.settings.harness);
  if (plan.Has("comparison")) CheckHasComparedFrames(sequence.name, objects, plan.settings);
}

void AddSequence(const std::filesystem::path& folder, BenchPlan& plan) {
  Sequence sequence = LoadSequence(folder, CategoryNames(plan.parts.models));
  for (const Sequence& other : plan.sequences) {
    if (other.name != sequence.name) continue;
    throw InputError(fmt::format("{}: a second sequence named '{}', tables could not be told apart; give one",
                                 folder.string(), sequence.name));
  }
  CheckFrames(sequence, plan);
  plan.sequences.push_back(std::move(sequence));
}

struct LoadedSequence {
  BenchSequence sequence;
  std::vector<FrameTruth> truth;
};

std::vector<LoadedSequence> LoadImages(const BenchPlan& plan) {
  const CadLibrary cad =
      plan.cad.empty() ? CadLibrary() : CadLibrary(plan.cad, CollectSpecs(plan.parts.models));
  std::vector<LoadedSequence> loaded;
  for (const Sequence& sequence : plan.sequences) {
    LoadedSequence& to = loaded.emplace_back();
    to.sequence = LoadBenchSequence(sequence, plan.frames);
    to.truth = LoadFrameTruth(sequence.folder, to.sequence, plan.parts.models, cad);
  }
  return loaded;
}

}  // namespace

BenchPlan::BenchPlan(const BenchArguments& a) : cad(a.cad), parts(MakeParts(a.configuration)) {
  CheckBenchArguments(a);
  frames = static_cast<size_t>(a.frames);
  settings = MakeSettings(a, parts);
  tables = MakeTables(a, settings.engines);
  micro_setup = MakeMicroSetup(parts);
  micro = ChosenMicroBenchmarks(MicroBenchmarks(micro_setup), a.micro);
  retrieval.sizes = RetrievalSizes(a.retrieval_sizes);
  if (std::none_of(tables.begin(), tables.end(), NeedsSequence)) return;
  if (a.sequences.empty()) {
    throw InputError(
        "SEQUENCE is missing: only '--tables micro' and '--tables retrieval' can do without; name sequence "
        "folders, see armature bench --help");
  }
  for (const std::filesystem::path& folder : a.sequences) AddSequence(folder, *this);
}

bool BenchPlan::Has(const std::string& table) const {
  return std::find(tables.begin(), tables.end(), table) != tables.end();
}

std::set<TableOfSequence> ListTablesOfSequences(const BenchPlan& plan) {
  std::set<TableOfSequence> all;
  for (const std::string& table : plan.tables) {
    if (!NeedsSequence(table)) {
      all.emplace(table, "");
      continue;
    }
    for (const Sequence& sequence : plan.sequences) all.emplace(table, sequence.name);
  }
  return all;
}

BenchReport Measure(const BenchPlan& plan) {
  std::map<std::string, BenchSection> memory;  // by sequence
  for (const Sequence& sequence : plan.sequences) {
    if (plan.Has(kMemoryTable))
      memory[sequence.name] = MemorySection(sequence, plan.frames, plan.parts, plan.settings);
  }
  cv::setNumThreads(plan.settings.threads);
  BenchReport report;
  Progress progress("bench: tables", static_cast<long>(ListTablesOfSequences(plan).size()));
  const auto add = [&](BenchSection section) {
    report.sections.push_back(std::move(section));
    progress.Step();
  };
  for (const auto& [sequence, truth] : LoadImages(plan)) {
    for (const std::string& table : plan.tables) {
      if (!NeedsSequence(table)) continue;
      add(table == kMemoryTable ? std::move(memory.at(sequence.name))
                                : MeasureSection(table, {sequence, truth, plan.parts, plan.settings}));
    }
  }
  if (plan.Has(kMicroTable)) add(MicroSection(plan.micro));
  if (plan.Has(kRetrievalTable)) add(RetrievalSection(plan.retrieval));
  return report;
}

}  // namespace armature
