// SPDX-License-Identifier: BSD-3-Clause
#include "bench/micro/micro_benchmarks.h"

#include <algorithm>
#include <set>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "bench/micro/micro_families.h"
#include "bench/sections/calibrated_race.h"

namespace armature {
namespace {

bool IsNamed(const MicroBenchmark& benchmark, const std::string& name) {
  return name == benchmark.family || name == benchmark.name();
}

void CheckNamesKnown(const std::vector<MicroBenchmark>& all, const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const MicroBenchmark& benchmark : all) {
    if (known.empty() || std::find(known.begin(), known.end(), benchmark.family) == known.end())
      known.push_back(benchmark.family);
  }
  for (const MicroBenchmark& benchmark : all) known.push_back(benchmark.name());
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InputError(UnknownNameMessage("micro-benchmark", name, known));
  }
}

std::optional<SpanStatistics> CallTimes(const std::vector<BenchRow>& rows, const std::string& contender) {
  std::vector<double> milliseconds;
  for (const BenchRow& row : rows) {
    if (row.contender == contender) milliseconds.push_back(row.wall_ms);
  }
  return ComputeStatistics(std::move(milliseconds));
}

std::vector<Cell> TableRow(const std::string& name, const NamedSpan* span) {
  if (!span) return {TextCell(name), CountCell(0), NoCell(), NoCell(), NoCell()};
  const SpanStatistics& ms = span->milliseconds;
  return {TextCell(name), CountCell(static_cast<long>(ms.n)), NumberCell(1000 * ms.median, 2),
          NumberCell(1000 * ms.p90, 2), NumberCell(1000 * ms.deviation, 2)};
}

}  // namespace

std::vector<MicroBenchmark> MicroBenchmarks(const MicroSetup& setup) {
  std::vector<MicroBenchmark> all;
  for (const auto& benchmarks : {AssociationBenchmarks(setup), ResectionBenchmarks(setup),
                                 PoseGraphBenchmarks(setup), NeighbourBenchmarks(setup)}) {
    all.insert(all.end(), benchmarks.begin(), benchmarks.end());
  }
  return all;
}

std::vector<MicroBenchmark> ChosenMicroBenchmarks(std::vector<MicroBenchmark> all,
                                                  const std::vector<std::string>& names) {
  if (names.empty()) return all;
  CheckNamesKnown(all, names);
  std::erase_if(all, [&](const MicroBenchmark& benchmark) {
    return std::none_of(names.begin(), names.end(),
                        [&](const std::string& name) { return IsNamed(benchmark, name); });
  });
  return all;
}

std::vector<NamedSpan> MicroSpans(const std::vector<MicroBenchmark>& benchmarks,
                                  const std::vector<BenchRow>& rows) {
  std::vector<NamedSpan> spans;
  for (const MicroBenchmark& benchmark : benchmarks) {
    if (const auto times = CallTimes(rows, benchmark.name()))
      spans.push_back({"micro", "", benchmark.name(), "call", *times});
  }
  return spans;
}

Table MicroTable(const std::vector<MicroBenchmark>& benchmarks, const std::vector<NamedSpan>& spans) {
  Table table;
  table.title = "Micro-benchmarks: single functions on fixed inputs";
  table.columns = {"benchmark", "n", "median [us]", "p90 [us]", "std [us]"};
  std::set<std::string> families;
  for (const MicroBenchmark& benchmark : benchmarks) {
    const auto span = std::find_if(spans.begin(), spans.end(), [&](const NamedSpan& s) {
      return s.table == "micro" && s.contender == benchmark.name();
    });
    table.rows.push_back(TableRow(benchmark.name(), span == spans.end() ? nullptr : &*span));
    if (families.insert(benchmark.family).second)
      table.notes.push_back(benchmark.family + ": " + benchmark.span + ".");
  }
  table.notes.push_back(
      "us: wall clock a call; n runs of many calls each, taking turns with the others, so p90 and std are of "
      "runs, not of calls.");
  return table;
}

BenchSection MicroSection(const std::vector<MicroBenchmark>& benchmarks) {
  BenchSection section{.name = "micro", .sequence = ""};
  std::vector<Contender> contenders;
  contenders.reserve(benchmarks.size());
  for (const MicroBenchmark& benchmark : benchmarks) contenders.push_back(benchmark.make());
  RaceCalibrated(std::move(contenders), kMicroRuns + kMicroWarmUp, {kMicroWarmUp, 1}, section);
  section.spans = MicroSpans(benchmarks, section.rows);
  section.tables = {MicroTable(benchmarks, section.spans)};
  return section;
}

}  // namespace armature
