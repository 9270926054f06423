// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sections/retrieval_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/errors.h"
#include "base/text.h"
#include "bench/guard/calibration.h"
#include "bench/retrieval/index_race.h"
#include "bench/retrieval/library_costs.h"
#include "bench/sections/bench_tables.h"

namespace armature {
namespace {

constexpr int kMostInstances = 5'000'000;
constexpr size_t kScanned = 40'000'000;  // instances that all queries of an exact scan look at: half a second
constexpr size_t kCalibrationPasses = 8;
const std::vector<int> kChecks = {32, 128, 512};

// What all methods are measured on.
struct RetrievalTask {
  SyntheticLibrary library;
  Answers truth;

  size_t instances() const { return static_cast<size_t>(library.features.cols()); }
};

IndexMethod ExactScan() {
  IndexMethod method;
  method.kind = IndexKind::kLinear;
  return method;
}

// One structure: an approximate one is searched with several numbers of checks.
std::vector<IndexMethod> MethodsOfKind(IndexKind kind) {
  IndexMethod method;
  method.kind = kind;
  if (IsExact(method)) return {method};
  std::vector<IndexMethod> methods;
  for (const int checks : kChecks) {
    method.checks = checks;
    methods.push_back(method);
  }
  return methods;
}

size_t CountQueries(const IndexMethod& method, const RetrievalTask& task) {
  if (method.kind != ExactScan().kind) return task.truth.size();
  return std::min(task.truth.size(), std::max(2 * kRetrievalWarmUp, kScanned / task.instances()));
}

BenchSeries& FindCurve(const std::string& contender, BenchSection& section) {
  for (BenchSeries& series : section.series) {
    if (series.contender == contender) return series;
  }
  return section.series.emplace_back(BenchSeries{
      .contender = contender, .x_label = "instances", .y_label = "the five nearest of a query [ms]"});
}

std::vector<Cell> IndexRow(size_t instances, const std::string& contender, const IndexCosts& costs,
                           double recall, const SpanStatistics& query) {
  return {CountCell(static_cast<long>(instances)),
          TextCell(contender),
          NumberCell(costs.build_ms, 2),
          NumberCell(costs.save_ms, 2),
          NumberCell(costs.load_ms, 2),
          NumberCell(costs.memory_mb, 2),
          NumberCell(costs.file_mb, 2),
          NumberCell(recall, 4),
          CountCell(static_cast<long>(query.n)),
          NumberCell(1000 * query.median, 1),
          NumberCell(1000 * query.p99, 1)};
}

std::vector<Cell> LibraryRow(size_t instances, const LibraryCosts& costs) {
  return {CountCell(static_cast<long>(instances)), NumberCell(costs.file_mb, 2),
          NumberCell(costs.write_ms, 1), NumberCell(costs.read_ms, 1), NumberCell(costs.weighed_ms, 3)};
}

void MeasureMethod(const IndexMethod& method, const RetrievalTask& task, SavedStructure& structure,
                   BenchSection& section) {
  const std::string contender = ContenderName(method);
  const std::string sized = fmt::format("{} of {}", contender, task.instances());
  Answers answers;
  std::vector<double> milliseconds;
  const InstanceIndex index = structure.Load(method);
  for (BenchRow& row : RaceQueries(index, task.library.queries, CountQueries(method, task), sized, answers)) {
    milliseconds.push_back(row.wall_ms);
    section.rows.push_back(std::move(row));
  }
  const SpanStatistics query = ComputeStatistics(std::move(milliseconds)).value();
  section.spans.push_back({section.name, "", sized, "query", query});
  const double recall = Recall(answers, task.truth);
  BenchSeries& curve = FindCurve(contender, section);
  curve.points.push_back({static_cast<double>(task.instances()), query});
  curve.remark = fmt::format(" ({:.3f})", recall);
  section.tables[0].rows.push_back(IndexRow(task.instances(), contender, structure.costs(), recall, query));
}

void AddCalibration(BenchSection& section) {
  for (const BenchRow& row : RunInterleaved({CalibrationContender()}, kCalibrationPasses, {.warm_up = 1}))
    section.calibration_ms.push_back(row.wall_ms);
}

void MeasureSize(size_t instances, size_t queries, BenchSection& section) {
  RetrievalTask task{
      MakeSyntheticLibrary(static_cast<Eigen::Index>(instances), static_cast<Eigen::Index>(queries)), {}};
  section.tables[1].rows.push_back(LibraryRow(instances, MeasureLibrary(task.library)));
  task.truth = CollectAnswers(InstanceIndex(task.library.features, ExactScan()), task.library.queries);
  for (const auto& [kind, name] : EnumNames<IndexKind>::kTable) {
    const std::vector<IndexMethod> methods = MethodsOfKind(kind);
    SavedStructure structure(task.library.features, methods.front());
    AddCalibration(section);
    for (const IndexMethod& method : methods) MeasureMethod(method, task, structure, section);
  }
}

std::vector<std::string> RetrievalNotes() {
  const IndexMethod m;
  std::vector<std::string> notes;
  notes.emplace_back(
      "instances: synthetic, seven coefficients in standard deviations, from a fixed seed: members of 300 "
      "families of uneven size (deviation 0.9 between families, 0.44 within one). A query is one of the "
      "instances with noise of 0.3 on each coefficient.");
  notes.push_back(fmt::format(
      "index: FLANN's. linear: an exact scan. kdtree_single: one KD-tree, {} instances a leaf, exact. "
      "kdtree:CHECKS: {} randomised KD-trees. kmeans:CHECKS: a k-means tree, {} branches, at most {} "
      "iterations. CHECKS: instances that a query looks at; the structure is the same for all of them.",
      m.leaf_size, m.trees, m.branching, m.iterations));
  notes.emplace_back(
      "build, save, load: once, of the structure; saving and loading with the checksums of features and "
      "file, in the folder for temporary files.");
  notes.emplace_back(
      "memory: the features (kdtree_single keeps them twice), a pointer to each instance and what FLANN "
      "counts for its structure; of 2^20 bytes, as file.");
  notes.emplace_back("recall@5: share of an exact scan's five nearest that are among those found.");
  notes.push_back(fmt::format(
      "us: wall clock of single queries, one thread, one method after the other; n of them after {} that "
      "do not count.",
      kRetrievalWarmUp));
  return notes;
}

Table EmptyTable() {
  return {.title = "Retrieval: the five nearest instances of a library",
          .columns = {"instances", "index", "build [ms]", "save [ms]", "load [ms]", "memory [MB]",
                      "file [MB]", "recall@5", "n", "median [us]", "p99 [us]"},
          .rows = {},
          .notes = RetrievalNotes()};
}

Table EmptyLibraryTable() {
  return {.title = "Retrieval: libraries as a whole",
          .columns = {"instances", "file [MB]", "write [ms]", "read [ms]", "by covariance [ms]"},
          .rows = {},
          .notes = {
              "file: coefficients, sizes, 11 edges, names and transforms of the same instances; write, read: "
              "once, with the checksum of everything, in the folder for temporary files.",
              "by covariance: the five likeliest, an exact scan in the query's own metric; median of 10 "
              "queries after 2 that do not count."}};
}

}  // namespace

std::vector<size_t> RetrievalSizes(const std::vector<std::string>& texts) {
  std::set<size_t> sizes;
  for (const std::string& text : texts) {
    const int size = ParseInteger(text, "--retrieval-sizes");
    if (size < 1 || size > kMostInstances)
      throw InputError(fmt::format("--retrieval-sizes {}: has to be from 1 to {}", size, kMostInstances));
    sizes.insert(static_cast<size_t>(size));
  }
  return {sizes.begin(), sizes.end()};
}

BenchSection RetrievalSection(const RetrievalSetup& setup) {
  BenchSection section{
      .name = kRetrievalTable, .sequence = "", .tables = {EmptyTable(), EmptyLibraryTable()}};
  section.frames = setup.queries - kRetrievalWarmUp;
  section.warmed_up = kRetrievalWarmUp;
  for (const size_t size : setup.sizes) MeasureSize(size, setup.queries, section);
  return section;
}

}  // namespace armature
