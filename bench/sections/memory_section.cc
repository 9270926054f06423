// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sections/memory_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/core.hpp>

#include "bench/bench_sequence.h"

namespace armature {
namespace {

size_t CountFrames(const Sequence& sequence, size_t limit) {
  const auto first = std::find_if(sequence.detections.begin(), sequence.detections.end(),
                                  [](const auto& detections) { return !detections.empty(); });
  const size_t to_first = static_cast<size_t>(first - sequence.detections.begin()) + 1;
  const size_t all = limit > 0 ? std::min(limit, sequence.images.size()) : sequence.images.size();
  return std::min(all, std::max(kMemoryFrames, to_first));
}

BenchSequence FewWithObjects(const BenchSequence& sequence) {
  BenchSequence few = FirstFrames(sequence, 0);
  for (const BenchFrame& frame : sequence.frames) {
    if (!frame.input.detections.empty() && few.frames.size() < kMemoryBaselineFrames)
      few.frames.push_back(frame);
  }
  return few;
}

void ProcessAll(const std::string& name, const BenchSequence& sequence, const EngineParts& parts) {
  const std::unique_ptr<Engine> engine = MakeEngine(name, parts);
  const BenchSequence frames = engine->IsStateless() ? FewWithObjects(sequence) : sequence;
  engine->Start(frames);
  for (const BenchFrame& frame : frames.frames) engine->Process(frame);
}

std::vector<std::string> Notes(const std::string& sequence, size_t frames, const BenchSettings& settings) {
  return {
      fmt::format("MB: 2^20 bytes that are resident, of a process of its own for each row, {} thread{}.",
                  settings.threads, settings.threads == 1 ? "" : "s"),
      "program before: what the program had loaded when the process began, with its libraries and category "
      "models. peak: at most, until the end. added: peak less program before.",
      fmt::format("Each process loads the first {} frames of {}; the first row does no more. Our pipeline "
                  "processes all of them, a baseline {} with objects, as it remembers nothing.",
                  frames, sequence, kMemoryBaselineFrames)};
}

}  // namespace

Table MemoryTable(const std::vector<NamedMemory>& processes) {
  Table table;
  table.columns = {"engine", "program before [MB]", "peak [MB]", "added [MB]"};
  for (const auto& [engine, memory] : processes) {
    table.rows.push_back({TextCell(engine), NumberCell(memory.before_mb, 1), NumberCell(memory.peak_mb, 1),
                          NumberCell(memory.added_mb(), 1)});
  }
  return table;
}

BenchSection MemorySection(const Sequence& sequence, size_t limit, const EngineParts& parts,
                           const BenchSettings& settings) {
  const size_t frames = CountFrames(sequence, limit);
  std::vector<NamedMemory> processes;
  const auto measure = [&](const std::string& row, const std::string& engine) {
    processes.push_back({row, MeasurePeakMemory([&] {
                           cv::setNumThreads(settings.threads);
                           const BenchSequence loaded = LoadBenchSequence(sequence, frames);
                           if (!engine.empty()) ProcessAll(engine, loaded, parts);
                         })});
  };
  measure("none, frames only", "");
  for (const std::string& engine : settings.engines) measure(engine, engine);
  BenchSection section{.name = "memory", .sequence = sequence.name, .frames = frames};
  Table& table = section.tables.emplace_back(MemoryTable(processes));
  table.title = sequence.name + ": peak memory";
  table.notes = Notes(sequence.name, frames, settings);
  return section;
}

}  // namespace armature
