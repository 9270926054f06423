// SPDX-License-Identifier: BSD-3-Clause
#include "eval/compare_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>

#include "base/console.h"
#include "base/errors.h"
#include "category/category_lookup.h"
#include "cli/compared_values.h"
#include "cli/help.h"
#include "cli/printed_tables.h"
#include "eval/eval_inputs.h"
#include "eval/rooms/room_statistics.h"
#include "eval/statistics/result_distance.h"
#include "eval/statistics/run_values.h"
#include "eval/trajectories/trajectory_alignment.h"
#include "io/atomic_write.h"
#include "io/provenance.h"
#include "io/run_folder.h"

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

bool IsInRoom(const RunToEvaluate& run) {
  return run.HasTruth("groundtruth.txt") && run.HasTruth("objects_gt.csv") && run.HasResult("objects.csv");
}

// The runs of rooms that both have, as two variants.
struct RoomPairs {
  std::vector<RunToEvaluate> a, b;
};

RoomPairs PairRuns(const RunsBySequence& runs_a, const RunsBySequence& runs_b) {
  RoomPairs pairs;
  for (const auto& [sequence, a] : runs_a) {
    const auto b = runs_b.find(sequence);
    if (b == runs_b.end() || !IsInRoom(a) || !IsInRoom(b->second)) continue;
    pairs.a.push_back(a);
    pairs.b.push_back(b->second);
    pairs.b.back().truth = a.truth;
  }
  return pairs;
}

// What makes rooms of two results hard to pair, each line once.
void WarnOfRooms(const RoomPairs& pairs, Comparison& comparison) {
  std::map<std::string, size_t> counts;
  for (size_t i = 0; i < pairs.a.size(); ++i) {
    for (const ProvenanceRemark& remark : CompareRunProvenance(pairs.a[i].run, pairs.b[i].run))
      if (remark.is_warning) ++counts[remark.text];
  }
  for (const auto& [text, count] : counts)
    comparison.warnings.push_back(fmt::format("in {} of {} rooms: {}", count, pairs.a.size(), text));
}

RoomVariant EvaluateAs(const fs::path& name, const std::vector<RunToEvaluate>& runs,
                       const std::vector<CategoryModel>& models, const ObjectEvaluationOptions& options) {
  RoomVariant variant = EvaluateRooms(runs, models, options).front();
  variant.name = name.string();
  return variant;
}

void AddRoomTable(const fs::path& a, const fs::path& b, const RoomPairs& pairs,
                  const std::vector<CategoryModel>& models, const ObjectEvaluationOptions& options,
                  Comparison& comparison) {
  comparison.tables.push_back(RoomDifferenceTable(
      CompareVariants(EvaluateAs(a, pairs.a, models, options), EvaluateAs(b, pairs.b, models, options))));
  comparison.tables.back().notes.push_back(
      fmt::format("Cameras and objects are brought to the truth by '{}'.", AlignmentName(options.alignment)));
}

// Sequence by sequence that both have a run of. Throws InputError: no sequence in common, two runs of one in
// A or B, the truth or models missing or malformed.
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
  if (const RoomPairs pairs = PairRuns(runs_a, runs_b); pairs.a.size() > 1)
    AddRoomTable(a, b, pairs, models, options, comparison);
  return comparison;
}

bool IsReproduction(const fs::path& folder) {
  return SaysComplete(folder / "environment.json") && fs::is_directory(folder / "runs");
}

// Variants that both have, by name.
std::vector<std::string> CommonVariants(const fs::path& a, const fs::path& b) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(a / "runs")) {
    const std::string name = entry.path().filename().string();
    if (fs::is_directory(b / "runs" / name)) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

// Over the rooms of two results of `armature reproduce`, variant by variant. Throws InputError: nothing in
// common, as above.
Comparison CompareReproductions(const fs::path& a, const fs::path& b, const CompareArguments& arguments) {
  const ObjectEvaluationOptions options{.alignment = AlignmentFromName(arguments.alignment)};
  const std::vector<CategoryModel> models = LoadModels(arguments.configuration);
  Comparison comparison;
  for (const std::string& variant : CommonVariants(a, b)) {
    const fs::path of_a = a / "runs" / variant, of_b = b / "runs" / variant;
    const RoomPairs pairs = PairRuns(CollectRuns(of_a, arguments), CollectRuns(of_b, arguments));
    if (pairs.a.empty()) continue;
    WarnOfRooms(pairs, comparison);
    AddRoomTable(of_a, of_b, pairs, models, options, comparison);
  }
  if (comparison.tables.empty())
    throw InputError(
        fmt::format("{} and {} have no variant and sequence with a truth in common", a.string(), b.string()));
  return comparison;
}

bool IsBench(const fs::path& folder) { return SaysComplete(folder / "bench.json"); }

void CheckKinds(const std::vector<fs::path>& results) {
  const auto benches = std::count_if(results.begin(), results.end(), IsBench);
  if (benches != 0 && benches != static_cast<std::ptrdiff_t>(results.size()))
    throw InputError("compare: some are benchmarks and some are not; compare runs with runs");
  const auto whole = std::count_if(results.begin(), results.end(), IsReproduction);
  if (whole != 0 && whole != static_cast<std::ptrdiff_t>(results.size()))
    throw InputError(
        "compare: some are results of `armature reproduce` and some are not; give all of them, or folders in "
        "their "
        "runs/");
}

Comparison Compare(const CompareArguments& arguments, const CompareFolders& compare_benches) {
  const fs::path& a = arguments.results.front();
  Comparison all;
  for (size_t i = 1; i < arguments.results.size(); ++i) {
    const fs::path& b = arguments.results[i];
    Comparison one = IsBench(a)          ? compare_benches(a, b)
                     : IsReproduction(a) ? CompareReproductions(a, b, arguments)
                                         : CompareRuns(a, b, arguments);
    std::move(one.tables.begin(), one.tables.end(), std::back_inserter(all.tables));
    for (const std::string& warning : one.warnings) all.warnings.push_back(b.string() + ": " + warning);
    all.raw += one.raw;
  }
  return all;
}

CommandHelp CompareHelp() {
  return {
      .description =
          "Puts results side by side with the first of them, A: errors and times are paired by frame, "
          "detection and object where the inputs agree, and the median difference is given with its 95 % "
          "interval and a mark where that leaves out zero. Warns where a pairing says little: other data, "
          "another machine, other models. Of several sequences in common, and of whole results of `armature "
          "reproduce`, differences over rooms are told: mean over the sequences, 95 % interval by bootstrap "
          "over "
          "them. Runs without ground truth are compared with each other.",
      .files = {{"RAW", "with --raw: a row a pair"}},
      .exit_status = {},
      .examples = {
          {"two ways of running the same sequences, paired",
           "armature compare results/reproduce/runs/objects results/reproduce/runs/fast --categories "
           "results/reproduce/categories"},
          {"the same variants before and after a change, over all rooms",
           "armature compare results/before results/after --categories results/before/categories"},
          {"two benchmarks, as Markdown", "armature compare runs/bench_a runs/bench_b --format markdown"}}};
}

}  // namespace

int RunCompare(const CompareArguments& arguments, const CompareFolders& compare_benches) {
  const TableFormat format = arguments.json ? TableFormat::kJson : TableFormatFromName(arguments.format);
  if (arguments.results.size() < 2) throw InputError("compare: give two results or more, the first is A");
  CheckKinds(arguments.results);
  const Comparison comparison = Compare(arguments, compare_benches);
  if (!arguments.raw.empty()) AtomicWrite(arguments.raw, RawPairColumns() + comparison.raw);
  for (const std::string& warning : comparison.warnings) Note("warning: " + warning);
  PrintResult(FormatTables(comparison.tables, format));
  return 0;
}

void AddCompareCommand(CLI::App& app, const CompareFolders& compare_benches, int& exit_status) {
  const auto arguments = std::make_shared<CompareArguments>();
  CompareArguments& a = *arguments;
  CLI::App* compare =
      app.add_subcommand("compare", "Compare runs, or benchmarks, with the first of them: pair by pair");
  Describe(*compare, CompareHelp());
  BeginSection(*compare, "What is compared");
  compare
      ->add_option(
          "RESULT", a.results,
          "run folders or folders of run folders, or all results of 'armature reproduce', or all folders of "
          "'armature bench --out'")
      ->type_name("DIR")
      ->required();
  compare
      ->add_option("--groundtruth", a.ground_truth,
                   "sequence folders with ground truth, or folders of such (default: where the run says)")
      ->type_name("DIR");
  KnownValues(*compare
                   ->add_option("--alignment", a.alignment,
                                "how cameras and objects are brought to the truth, or B to A without one")
                   ->type_name("NAME")
                   ->capture_default_str(),
              AlignmentNames());
  AddCategoriesArguments(*compare, a.configuration);
  BeginSection(*compare, "Output");
  AddFormatArguments(*compare, a.format, a.json);
  compare->add_option("--raw", a.raw, "also write a row a pair to this file (CSV)")->type_name("FILE");
  compare->callback(
      [arguments, compare_benches, &exit_status] { exit_status = RunCompare(*arguments, compare_benches); });
}

}  // namespace armature
