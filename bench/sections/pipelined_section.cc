// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sections/pipelined_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <optional>

#include "base/interrupt.h"
#include "bench/lines_engine.h"
#include "bench/spans.h"
#include "pipeline/one_ahead.h"

namespace armature {
namespace {

using Clock = std::chrono::steady_clock;

constexpr size_t kRuns = 3;  // of each mode, at least

double MillisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

struct FoundLines {
  Clock::time_point begun;
  DetectedLines lines;
};

PacedRun RunPaced(const BenchTask& task, const std::string& engine, bool pipelined) {
  const std::vector<BenchFrame>& frames = task.sequence.frames;
  const auto pipeline = MakePipeline(MakeOptions(engine, task.parts), task.parts.models, task.sequence);
  const std::function<FoundLines(size_t)> find = [&](size_t i) {
    const Clock::time_point begun = Clock::now();
    return FoundLines{begun, pipeline->DetectLines(frames[i].gray, frames[i].input.detections)};
  };
  std::optional<OneAhead<FoundLines>> ahead;
  if (pipelined) ahead.emplace(frames.size(), find);
  PacedRun run{engine, pipelined, {}, 0};
  Clock::time_point start = Clock::now();
  for (size_t i = 0; i < frames.size(); ++i) {
    ThrowIfInterrupted();
    if (i == task.settings.harness.warm_up) start = Clock::now();
    FoundLines found = ahead ? ahead->Take() : find(i);
    pipeline->Process(std::move(found.lines), frames[i].input);
    if (i >= task.settings.harness.warm_up) run.latency_ms.push_back(MillisecondsSince(found.begun));
  }
  run.frames_per_second = 1000 * static_cast<double>(run.latency_ms.size()) / MillisecondsSince(start);
  return run;
}

std::string ModeName(const PacedRun& run) { return run.pipelined ? "two threads" : "one thread"; }

std::vector<PacedRun> RunAll(const BenchTask& task) {
  std::vector<PacedRun> runs;
  for (size_t repetition = 0; repetition < std::max(kRuns, task.settings.harness.repetitions); ++repetition) {
    for (const std::string& engine : task.settings.engines) {
      if (!IsLinesEngine(engine)) continue;
      for (const bool pipelined : {repetition % 2 == 1, repetition % 2 == 0}) {
        runs.push_back(RunPaced(task, engine, pipelined));
      }
    }
  }
  return runs;
}

struct ModeSummary {
  std::vector<double> latency_ms, frames_per_second;
};

ModeSummary MakeSummary(const std::vector<PacedRun>& runs, const std::string& engine, bool pipelined) {
  ModeSummary summary;
  for (const PacedRun& run : runs) {
    if (run.engine != engine || run.pipelined != pipelined) continue;
    summary.latency_ms.insert(summary.latency_ms.end(), run.latency_ms.begin(), run.latency_ms.end());
    summary.frames_per_second.push_back(run.frames_per_second);
  }
  return summary;
}

std::vector<BenchRow> CollectRows(const std::vector<PacedRun>& runs, size_t warm_up) {
  std::vector<BenchRow> rows;
  std::map<std::string, size_t> repetitions;
  for (const PacedRun& run : runs) {
    const std::string name = run.engine + " " + ModeName(run);
    const size_t repetition = repetitions[name]++;
    for (size_t i = 0; i < run.latency_ms.size(); ++i) {
      rows.push_back({.contender = name,
                      .repetition = repetition,
                      .input = warm_up + i,
                      .wall_ms = run.latency_ms[i],
                      .outcome = {}});
    }
  }
  return rows;
}

}  // namespace

Table PipelinedTable(const std::vector<PacedRun>& runs) {
  Table table;
  table.columns = {"engine", "threads", "n", "latency [ms]", "p90", "p99", "frames/s", "times one thread"};
  for (const PacedRun& first : runs) {
    const bool is_known = std::any_of(table.rows.begin(), table.rows.end(),
                                      [&](const auto& row) { return row[0].text == first.engine; });
    if (is_known) continue;
    const std::optional<double> single =
        ComputeMedian(MakeSummary(runs, first.engine, false).frames_per_second);
    for (const bool pipelined : {false, true}) {
      const ModeSummary mode = MakeSummary(runs, first.engine, pipelined);
      const auto latency = ComputeStatistics(mode.latency_ms);
      const std::optional<double> pace = ComputeMedian(mode.frames_per_second);
      if (!latency || !pace || !single) continue;
      table.rows.push_back({TextCell(first.engine), CountCell(pipelined ? 2 : 1),
                            CountCell(static_cast<long>(latency->n)), NumberCell(latency->median, 2),
                            NumberCell(latency->p90, 2), NumberCell(latency->p99, 2), NumberCell(pace, 1),
                            NumberCell(*pace / *single, 2)});
    }
  }
  table.notes = {
      "threads: 1, a frame's lines and then its objects; 2, a second thread finds the next frame's lines "
      "meanwhile (`armature run --pipelined`). The results are the same.",
      "latency: from the moment that a frame's lines begin to be looked for to its result; with two threads "
      "they wait for the frame before. frames/s: median of whole runs, as fast as possible, images loaded "
      "before, without the warm-up. times one thread: of frames/s."};
  return table;
}

BenchSection PipelinedSection(const BenchTask& task) {
  const size_t warm_up = task.settings.harness.warm_up, frames = task.sequence.frames.size();
  CheckLongerThanWarmUp(frames, task.settings.harness);
  const std::vector<PacedRun> runs = RunAll(task);
  BenchSection section{.name = kPipelinedTable, .sequence = task.sequence.name};
  section.frames = frames - warm_up;
  section.warmed_up = warm_up;
  section.rows = CollectRows(runs, warm_up);
  section.tables = {PipelinedTable(runs)};
  section.tables.front().title =
      fmt::format("{}: one thread against two, {} frames", task.sequence.name, section.frames);
  return section;
}

}  // namespace armature
