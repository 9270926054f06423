// SPDX-License-Identifier: BSD-3-Clause
#include "eval/eval_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>

#include "base/console.h"
#include "base/errors.h"
#include "base/nearest_name.h"
#include "cli/help.h"
#include "cli/printed_tables.h"
#include "eval/eval_inputs.h"
#include "eval/eval_output.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

void CheckTableNames(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (std::find(kTableNames.begin(), kTableNames.end(), name) != kTableNames.end()) continue;
    throw InputError(UnknownNameMessage("table", name, kTableNames));
  }
}

bool IsAsked(const std::string& table, const EvalArguments& arguments) {
  return std::find(arguments.tables.begin(), arguments.tables.end(), table) != arguments.tables.end();
}

// The kinds that the user asks for, of those given.
std::vector<std::string> Asked(const std::vector<std::string>& kinds, const EvalArguments& arguments) {
  std::vector<std::string> names;
  std::copy_if(kinds.begin(), kinds.end(), std::back_inserter(names),
               [&](const std::string& name) { return IsAsked(name, arguments); });
  return names;
}

// The runs that kinds of tables are made of: all where the user asks for some of them, where the user does
// not choose those that have what they need.
std::vector<RunToEvaluate> RunsFor(const std::vector<std::string>& asked, const EvalArguments& arguments,
                                   const std::vector<RunToEvaluate>& runs,
                                   const std::function<bool(const RunToEvaluate&)>& has_needed) {
  if (!asked.empty()) return runs;
  std::vector<RunToEvaluate> chosen;
  if (arguments.tables.empty())
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(chosen), has_needed);
  return chosen;
}

Evaluation ObservationTables(const EvalArguments& arguments, const std::vector<RunToEvaluate>& runs) {
  const std::vector<std::string> asked = Asked(kObservationTableNames, arguments);
  const auto observed = RunsFor(asked, arguments, runs,
                                [](const RunToEvaluate& run) { return run.HasTruth("objects_gt.csv"); });
  if (observed.empty()) return {};
  return MakeRunObservationTables(observed, LoadModels(arguments.configuration),
                                  asked.empty() ? kObservationTableNames : asked, !asked.empty(),
                                  arguments.observations);
}

Evaluation TrajectoryTables(const EvalArguments& arguments, const std::vector<RunToEvaluate>& runs,
                            TableFormat format) {
  const auto moved = RunsFor(Asked({"trajectory"}, arguments), arguments, runs, [](const RunToEvaluate& run) {
    return run.HasTruth("groundtruth.txt") && run.HasResult("trajectory.txt");
  });
  if (moved.empty()) return {};
  return MakeRunTrajectoryTables(moved, arguments.trajectories, format);
}

Evaluation ObjectTables(const EvalArguments& arguments, const std::vector<RunToEvaluate>& runs) {
  const std::vector<std::string> asked = Asked(kObjectTableNames, arguments);
  const auto placed = RunsFor(asked, arguments, runs, [](const RunToEvaluate& run) {
    return run.HasTruth("objects_gt.csv") && run.HasTruth("groundtruth.txt");
  });
  if (placed.empty()) return {};
  ObjectArguments objects = arguments.objects;
  objects.first_n = arguments.trajectories.first_n;
  objects.tolerance = arguments.trajectories.tolerance;
  return MakeRunObjectTables(placed, LoadModels(arguments.configuration),
                             asked.empty() ? kObjectTableNames : asked, !asked.empty(), objects);
}

Evaluation RetrievalTables(const EvalArguments& arguments, const std::vector<RunToEvaluate>& runs) {
  std::vector<std::string> names = Asked(kRetrievalTableNames, arguments);
  if (arguments.tables.empty() && !arguments.retrieval.library.empty()) names = {"retrieval"};
  if (names.empty()) return {};
  return MakeRunRetrievalTables(runs, LoadModels(arguments.configuration), names, arguments.observations.cad,
                                arguments.retrieval);
}

Evaluation RoomTables(const EvalArguments& arguments, const std::vector<RunToEvaluate>& runs) {
  const std::vector<std::string> names = Asked(kRoomTableNames, arguments);
  if (names.empty()) return {};
  ObjectArguments objects = arguments.objects;
  objects.first_n = arguments.trajectories.first_n;
  objects.tolerance = arguments.trajectories.tolerance;
  return MakeRunRoomTables(runs, LoadModels(arguments.configuration), names, objects, arguments.raw_rooms);
}

Evaluation MakeFolderTables(const EvalArguments& arguments, TableFormat format) {
  // Each room is judged by the truth of its own run; other tables put the runs of a sequence together.
  const bool are_over_rooms =
      !arguments.tables.empty() && Asked(kRoomTableNames, arguments).size() == arguments.tables.size();
  const std::vector<RunToEvaluate> runs =
      FindRuns(arguments.runs, arguments.ground_truth,
               are_over_rooms ? RunsOfASequence::kOfOneOrigin : RunsOfASequence::kOfOneFolder);
  Evaluation made = MakeRunTables(arguments, runs, format);
  if (!made.tables.empty() || IsAsked(kLibraryTableName, arguments)) return made;
  throw InputError(fmt::format(
      "{}: has neither groundtruth.txt nor objects_gt.csv; give the folder of the ground truth with "
      "--groundtruth",
      runs.front().truth.string()));
}

bool AreTrajectoryFiles(const std::vector<fs::path>& runs) {
  return std::all_of(runs.begin(), runs.end(), [](const fs::path& run) { return fs::is_regular_file(run); });
}

Evaluation MakeFileTables(const EvalArguments& arguments, TableFormat format) {
  const auto& asked = arguments.tables;
  if (!asked.empty() && asked != std::vector<std::string>{"trajectory"}) {
    throw InputError(
        fmt::format("{}: is a trajectory file, which has only the table 'trajectory'; give a run",
                    arguments.runs.front().string()));
  }
  if (!arguments.observations.raw.empty())
    throw InputError("--raw: is of detections; use --raw-trajectory with files");
  if (!arguments.retrieval.library.empty())
    throw InputError("--library: is for the objects of runs; trajectory files have none");
  return MakeFileTrajectoryTables(arguments.runs, arguments.ground_truth, arguments.trajectories, format);
}

Evaluation TablesWithoutRuns(const EvalArguments& arguments) {
  const auto& asked = arguments.tables;
  const bool of_library = asked.empty() ? !arguments.retrieval.library.empty()
                                        : asked == std::vector<std::string>{kLibraryTableName};
  if (!of_library)
    throw InputError(
        "eval: no run is given; name run folders, or --library FILE for the table 'library' alone");
  return {.tables = {MakeLibraryTable(LoadModels(arguments.configuration), arguments.retrieval)}};
}

bool IsOfDetections(const EvalArguments& arguments) {
  return !arguments.detections.empty() || IsAsked(kDetectionTableName, arguments);
}

Evaluation MakeSequenceTables(const EvalArguments& arguments) {
  const auto& asked = arguments.tables;
  if (!asked.empty() && asked != std::vector<std::string>{kDetectionTableName}) {
    throw InputError(fmt::format("--tables: '{}' is of sequences, the others are of runs; ask for it alone",
                                 kDetectionTableName));
  }
  if (arguments.runs.empty()) {
    throw InputError("eval: no sequence is given; name the folders whose detections are judged");
  }
  return MakeDetectionTables(arguments.runs, arguments.detections, LoadModels(arguments.configuration));
}

Evaluation MakeTables(const EvalArguments& arguments, TableFormat format) {
  if (IsOfDetections(arguments)) return MakeSequenceTables(arguments);
  if (arguments.runs.empty()) return TablesWithoutRuns(arguments);
  if (AreTrajectoryFiles(arguments.runs)) return MakeFileTables(arguments, format);
  Evaluation made = MakeFolderTables(arguments, format);
  if (IsAsked(kLibraryTableName, arguments))
    made.tables.push_back(MakeLibraryTable(LoadModels(arguments.configuration), arguments.retrieval));
  return made;
}

// Raw rows go into the folder, too, unless a file is named for them.
void KeepRawRows(const fs::path& folder, EvalArguments& a) {
  const auto keep = [&](fs::path& file, const char* name) {
    if (file.empty()) file = folder / name;
  };
  if (IsOfDetections(a)) return;  // they have none
  keep(a.trajectories.raw, "trajectories.csv");
  if (AreTrajectoryFiles(a.runs)) return;
  keep(a.observations.raw, "detections.csv");
  if (IsAsked("edges", a)) keep(a.observations.raw_edges, "edges.csv");  // else it would demand their truth
  keep(a.objects.raw, "objects.csv");
  keep(a.raw_rooms.objects, "room_objects.csv");
  keep(a.raw_rooms.rooms, "rooms.csv");
}

CommandHelp EvalHelp() {
  return {
      .description =
          "Compares finished runs with the ground truth of their sequences, which no other command reads, "
          "and prints tables: single views, matched edges, trajectories, objects of the map beside the "
          "paper's numbers and, with a library, retrieved CAD models. What each number is stands below its "
          "table. Over many sequences - rooms - the tables rooms, room_differences, room_factors and others "
          "give each way of running (runs of one name) with intervals. Single trajectory files (TUM, KITTI, "
          "EuRoC) can be compared, too, and detections, without any run: of a sequence folder or, for it, of "
          "a file.",
      .files = {{"OUT/records.json", "all numbers by name (ate_rmse_m), for programs; see results/README.md"},
                {"OUT/eval.json", "all tables and where they are from"},
                {"OUT/tables.*", "the tables as txt, md, csv and tex"},
                {"OUT/*.csv", "all raw rows: trajectories, detections, objects and, if asked for, edges"}},
      .exit_status = {{"1", "also: a trajectory has no pose with a true one; the tables are there"}},
      .examples = {
          {"all tables of three runs",
           "armature eval results/reproduce/runs/objects --categories results/reproduce/categories --out "
           "runs/eval"},
          {"how well CAD models are retrieved, as Markdown",
           "armature eval results/reproduce/runs/objects --categories results/reproduce/categories --library "
           "results/reproduce/library.armlib --tables retrieval --format markdown"},
          {"two ways of running, over all their sequences as rooms",
           "armature eval results/reproduce/runs/objects results/reproduce/runs/fast --categories "
           "results/reproduce/categories --tables rooms,room_differences,worst_rooms"},
          {"one trajectory, rigidly aligned",
           "armature eval results/reproduce/runs/objects/seq1/trajectory.txt --groundtruth "
           "datasets/generated/seq1/groundtruth.txt --alignment se3"},
          {"how good a detector is on a sequence",
           "armature eval datasets/generated/seq1 --detections my_detections.csv"}}};
}

}  // namespace

Evaluation MakeRunTables(const EvalArguments& arguments, const std::vector<RunToEvaluate>& runs,
                         TableFormat format) {
  Evaluation made;
  made.records.runs = MakeRunRecords(runs);
  const auto timed = [&](const char* what, const auto& make) {
    const StepDetail step(what);
    made.Append(make());
  };
  timed("tables of single views", [&] { return ObservationTables(arguments, runs); });
  timed("tables of trajectories", [&] { return TrajectoryTables(arguments, runs, format); });
  timed("tables of objects", [&] { return ObjectTables(arguments, runs); });
  timed("tables over rooms", [&] { return RoomTables(arguments, runs); });
  timed("tables of retrieval", [&] { return RetrievalTables(arguments, runs); });
  return made;
}

int RunEval(EvalArguments arguments) {
  const TableFormat format = arguments.json ? TableFormat::kJson : TableFormatFromName(arguments.format);
  CheckTableNames(arguments.tables);
  std::optional<EvalFolder> folder;
  if (!arguments.out.empty()) {
    folder.emplace(arguments.out);
    KeepRawRows(folder->partial(), arguments);
  }
  const Evaluation made = MakeTables(arguments, format);
  if (folder) WriteEvaluation(arguments.runs, made, *folder);
  PrintResult(FormatTables(made.tables, format));
  for (const std::string& failure : made.failures) PrintError(failure);
  return made.failures.empty() ? 0 : 1;
}

void AddEvalCommand(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<EvalArguments>();
  EvalArguments& a = *arguments;
  CLI::App* eval = app.add_subcommand("eval", "Compare runs with the ground truth of their sequences");
  Describe(*eval, EvalHelp());
  BeginSection(*eval, "Input");
  eval->add_option("RUN", a.runs,
                   "run folders, or folders of run folders; or trajectory files; none: "
                   "--library alone; for --detections: sequence folders")
      ->type_name("PATH");
  eval->add_option("--groundtruth", a.ground_truth,
                   "sequence folders with ground truth, or folders of such (default: where the run says); "
                   "for trajectory files: the true one")
      ->type_name("PATH");
  eval->add_option("--detections", a.detections,
                   "detections to judge by the truth of a sequence, in place of its own; those are the table "
                   "'detections'")
      ->type_name("FILE");
  BeginSection(*eval, "Output");
  KnownValues(*eval->add_option("--tables", a.tables, "which tables (default: all that there is truth for)")
                   ->type_name("NAME")
                   ->delimiter(','),
              kTableNames);
  AddFormatArguments(*eval, a.format, a.json);
  eval->add_option("--out", a.out, "also write records.json, the tables and all raw rows to this folder")
      ->type_name("DIR");
  AddObservationArguments(*eval, a.observations);
  AddTrajectoryArguments(*eval, a.trajectories);
  AddObjectArguments(*eval, a.objects);
  AddRetrievalTableArguments(*eval, a.retrieval);
  AddCategoriesArguments(*eval, a.configuration);
  eval->callback([arguments, &exit_status] { exit_status = RunEval(*arguments); });
}

}  // namespace armature
