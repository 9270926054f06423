// SPDX-License-Identifier: BSD-3-Clause
#include "eval/compare_runs.h"

#include <fmt/format.h>

#include <iterator>
#include <map>

#include "base/errors.h"
#include "category/category_lookup.h"
#include "eval/eval_inputs.h"
#include "eval/statistics/result_distance.h"
#include "eval/statistics/run_values.h"
#include "io/provenance.h"

namespace armature {
namespace {

namespace fs = std::filesystem;
using RunsBySequence = std::map<std::string, RunToEvaluate>;

RunsBySequence CollectRuns(const fs::path& folder, const CompareArguments& arguments) {
  RunsBySequence runs;
  for (const RunToEvaluate& run : FindRuns({folder}, arguments.ground_truth)) {
    const auto [other, is_new] = runs.emplace(run.run.sequence, run);
    if (!is_new) {
      throw InputError(fmt::format("{}: '{}' and '{}' are both of sequence '{}'; give one of them",
                                   folder.string(), other->second.run.folder.filename().string(),
                                   run.run.folder.filename().string(), run.run.sequence));
    }
  }
  return runs;
}

std::string ListSequences(const RunsBySequence& runs) {
  std::string names;
  for (const auto& [sequence, run] : runs) names += (names.empty() ? "" : ", ") + sequence;
  return names;
}

// Against the truth of A, which is B's too where they are of the same data; then times.
std::vector<NamedValues> CollectValues(const RunToEvaluate& run, const fs::path& truth,
                                       const std::vector<CategoryModel>& models,
                                       const ObjectEvaluationOptions& options) {
  std::vector<NamedValues> values = ComputeRunErrors(run.run.folder, truth, models, options);
  std::vector<NamedValues> times = ReadRunTimes(run.run.folder);
  std::move(times.begin(), times.end(), std::back_inserter(values));
  return values;
}

// Of what no truth tells which of them is better.
std::vector<ComparedValues> DistancesWithoutTruth(const RunToEvaluate& a, const RunToEvaluate& b,
                                                  const std::vector<CategoryModel>& models,
                                                  const ObjectEvaluationOptions& options) {
  const bool cameras = a.HasTruth("groundtruth.txt"), objects = cameras && a.HasTruth("objects_gt.csv");
  if (objects) return {};
  std::vector<ComparedValues> distances =
      ResultDistances(a.run.folder, b.run.folder, CollectSpecs(models), options);
  std::erase_if(distances, [&](const ComparedValues& of) { return cameras && of.name == kCameraDistance; });
  return distances;
}

void AddTable(Table table, const std::string& what, const RunToEvaluate& a, const RunToEvaluate& b,
              Comparison& comparison) {
  table.title = fmt::format("{} of {}: A = {}, B = {}", what, a.run.sequence, a.run.folder.string(),
                            b.run.folder.string());
  table.sequence = a.run.sequence;
  comparison.tables.push_back(std::move(table));
}

void CompareRun(const RunToEvaluate& a, const RunToEvaluate& b, const std::vector<CategoryModel>& models,
                const ObjectEvaluationOptions& options, Comparison& comparison) {
  const auto add_raw = [&](const std::vector<ComparedValues>& compared) {
    comparison.raw += RawPairRows(b.run.folder.string(), a.run.sequence, compared);
  };
  const std::vector<ComparedValues> differences =
      PairValues(CollectValues(a, a.truth, models, options), CollectValues(b, a.truth, models, options));
  Table table = DifferenceTable(differences);
  table.name = "differences";
  table.notes.push_back(
      fmt::format("Cameras and objects are brought to the truth by '{}'.", AlignmentName(options.alignment)));
  std::vector<ProvenanceRemark> remarks = CompareRunProvenance(a.run, b.run);
  if (const auto busy = PaceRemark(differences)) remarks.push_back({*busy, true});
  for (const ProvenanceRemark& remark : remarks) {
    if (remark.is_warning) comparison.warnings.push_back(fmt::format("{}: {}", a.run.sequence, remark.text));
    table.notes.push_back(remark.text);
  }
  AddTable(std::move(table), "Differences", a, b, comparison);
  add_raw(differences);
  const auto distances = DistancesWithoutTruth(a, b, models, options);
  if (distances.empty()) return;
  table = DistanceTable(distances);
  table.name = "distances";
  AddTable(std::move(table), "Distances", a, b, comparison);
  add_raw(distances);
}

}  // namespace

Comparison CompareRuns(const fs::path& a, const fs::path& b, const CompareArguments& arguments) {
  const ObjectEvaluationOptions options{.alignment = AlignmentFromName(arguments.alignment)};
  const std::vector<CategoryModel> models = LoadModels(arguments.configuration);
  const RunsBySequence runs_a = CollectRuns(a, arguments), runs_b = CollectRuns(b, arguments);
  Comparison comparison;
  for (const auto& [sequence, run_a] : runs_a) {
    const auto run_b = runs_b.find(sequence);
    if (run_b != runs_b.end())
      CompareRun(run_a, run_b->second, models, options, comparison);
    else
      comparison.warnings.push_back(fmt::format("{}: B has no run of it", sequence));
  }
  if (comparison.tables.empty()) {
    throw InputError(fmt::format("{} and {} have no sequence in common: {}, and {}; compare runs of the same",
                                 a.string(), b.string(), ListSequences(runs_a), ListSequences(runs_b)));
  }
  for (const auto& [sequence, run] : runs_b) {
    if (!runs_a.contains(sequence))
      comparison.warnings.push_back(fmt::format("{}: A has no run of it", sequence));
  }
  return comparison;
}

}  // namespace armature
