// SPDX-License-Identifier: BSD-3-Clause
#include "app/reproduce/reproduce_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>
#include <optional>
#include <thread>

#include "app/reproduce/all_tables.h"
#include "app/reproduce/job_scheduler.h"
#include "app/reproduce/matrix_tables.h"
#include "app/reproduce/matrix_yaml.h"
#include "app/reproduce/plan_jobs.h"
#include "app/reproduce/read_matrix.h"
#include "app/reproduce/reproduction_folder.h"
#include "base/console.h"
#include "base/errors.h"
#include "base/interrupt.h"
#include "base/nearest_name.h"
#include "base/progress.h"
#include "cli/data_folders.h"
#include "cli/help.h"
#include "cli/printed_tables.h"
#include "io/atomic_write.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

RoomSet MakeRoomSet(const ReproduceArguments& a) {
  RoomSet rooms = ReadRoomSet(a.rooms);
  if (a.count > 0) rooms.count = a.count;
  if (!a.split.empty()) {
    const std::vector<std::string> known(kRoomSplits.begin(), kRoomSplits.end());
    if (std::find(known.begin(), known.end(), a.split) == known.end())
      throw InputError("--split: " + UnknownNameMessage("split", a.split, known));
    rooms.split = a.split;
  }
  if (a.seed) rooms.split = std::to_string(*a.seed);
  rooms.collections = a.collections;
  rooms.lines_only = a.lines_only;
  return rooms;
}

void CheckRoomArguments(const ReproduceArguments& a) {
  if (!a.rooms.empty() && !a.sequences.empty())
    throw InputError("reproduce: --rooms and sequence folders exclude each other; call it twice");
  const bool needs_rooms =
      a.count > 0 || !a.split.empty() || a.seed || !a.collections.empty() || a.lines_only;
  if (needs_rooms && a.rooms.empty())
    throw InputError(
        "reproduce: --count, --split, --seed, --collection and --lines-only are of --rooms; name a recipe");
}

Matrix LoadMatrix(const ReproduceArguments& a) {
  CheckRoomArguments(a);
  Matrix matrix = ReadMatrix(a.config.empty() ? ConfigsFolder(a.configs) / "reproduce.yaml" : a.config,
                             {.fast = a.fast, .has_own_sequences = !a.sequences.empty() || !a.rooms.empty()});
  if (!a.data.empty()) matrix.data = a.data;
  if (!a.cad.empty()) matrix.cad = fs::absolute(a.cad).lexically_normal();
  if (!a.sequences.empty()) ReplaceSequences(a.sequences, matrix);
  if (!a.rooms.empty()) {
    ReplaceByRooms(MakeRoomSet(a), matrix);
    matrix.name = matrix.rooms->name + "-" + matrix.rooms->split + KindOfRooms(*matrix.rooms);
  }
  if (!a.variants.empty()) SelectVariants(a.variants, ConfigsFolder(a.configs), matrix);
  AddDetections(a.detections, matrix);
  if (a.jitter > 0) matrix.jitter = a.jitter;
  if (!a.categories.empty()) {
    matrix.categories.clear();
    matrix.category_folder = fs::absolute(a.categories).lexically_normal();
  }
  if (a.seeds > 0) matrix.seeds = a.seeds;
  if (!a.only.empty()) {
    KeepOnly(a.only, matrix);
    matrix.name += "-only";  // it is not to replace the whole
  }
  CheckNamesDiffer(matrix);
  if (!a.name.empty()) matrix.name = a.name;
  if (fs::path(matrix.name).filename() != matrix.name || matrix.name == "latest")
    throw InputError(
        fmt::format("--name {}: has to be the plain name of a folder, and not 'latest'", matrix.name));
  return matrix;
}

// An interrupted call may have been of another matrix: its runs are not to be evaluated with those of this
// one.
void RemoveOtherRuns(const fs::path& results, const std::string& below, const std::vector<Job>& jobs) {
  std::error_code absent;
  for (const auto& variant : fs::directory_iterator(results / below, absent)) {
    for (const auto& run : fs::directory_iterator(variant.path(), absent)) {
      const std::string name = run.path().lexically_relative(results).string();
      if (std::none_of(jobs.begin(), jobs.end(), [&](const Job& job) { return job.name == name; }))
        fs::remove_all(run.path());
    }
  }
}

// All jobs of a matrix, phase after phase: what comes later is of what has succeeded before.
class Reproduction {
 public:
  Reproduction(const Matrix& matrix, const ReproduceArguments& arguments, const ReproductionFolder& results)
      : matrix_(matrix),
        folders_{results.partial(), fs::absolute(ConfigsFolder(arguments.configs)).lexically_normal(),
                 !arguments.configs.empty()},
        job_folders_{results.partial(), results.folder(), fs::read_symlink("/proc/self/exe")},
        at_once_(arguments.jobs > 0 ? arguments.jobs
                                    : static_cast<int>(std::thread::hardware_concurrency())) {}

  void Run() {
    const std::vector<Job> runs = PlanRuns(matrix_, folders_);
    for (const char* below : {"runs", "jitter"}) RemoveOtherRuns(folders_.results, below, runs);
    Do("runs and timings", runs);
    Do("evaluation", PlanEvaluation(matrix_, folders_, done_));
    WriteTables();
    Do("report", {PlanReport(matrix_, folders_, done_, FilesToReport())});
  }

  const std::vector<JobRecord>& done() const { return done_; }
  const std::vector<Table>& tables() const { return tables_; }
  // Folders of evaluations whose tables are the main ones, too.
  std::vector<fs::path> main_evaluations() const {
    return IsDone(kRoomsJob) ? std::vector{folders_.results / kRoomsJob} : std::vector<fs::path>{};
  }

 private:
  void Do(const std::string& phase, const std::vector<Job>& jobs) {
    if (jobs.empty()) return;
    Progress progress("reproduce: " + phase, static_cast<long>(jobs.size()));
    std::vector<JobRecord> records =
        RunJobs(jobs, job_folders_, at_once_, hashes_, [&](const JobRecord& record) {
          if (record.status == JobStatus::kFailed)
            Note(fmt::format("{} failed: {}", record.name, record.reason));
          progress.Step();
        });
    std::move(records.begin(), records.end(), std::back_inserter(done_));
  }

  bool IsDone(const std::string& name) const {
    return std::any_of(done_.begin(), done_.end(),
                       [&](const JobRecord& job) { return job.name == name && job.HasSucceeded(); });
  }

  // Of rooms, those are shown in pictures in which the first variant did worst.
  ReportedFiles FilesToReport() const {
    if (!matrix_.rooms) return {.tables = {"evaluation/matrix.json"}};
    ReportedFiles files;
    if (!IsDone(kRoomsJob)) return files;
    for (const WorstRoomRecord& room :
         ReadEvaluationRecords(folders_.results / kRoomsJob / "records.json").worst_rooms)
      files.runs.push_back(room.folder);
    return files;
  }

  // None where nothing was evaluated, or that failed.
  std::optional<MatrixEvaluation> ReadEvaluation() const {
    if (!IsDone(kAccuracyJob)) return std::nullopt;
    const fs::path file = folders_.results / kAccuracyJob / "records.json";
    return MatrixEvaluation{file, ReadEvaluationRecords(file)};
  }

  // Those of the matrix itself; the rest are the evaluation's and the benchmarks'.
  void WriteTables() {
    if (matrix_.rooms) return;  // the evaluation's say it over all of them
    const std::optional<MatrixEvaluation> evaluation = ReadEvaluation();
    const MatrixEvaluation* known = evaluation ? &*evaluation : nullptr;
    tables_ = {MatrixTable(matrix_, done_, known)};
    if (auto draws = DrawsTable(matrix_, done_, known)) tables_.push_back(std::move(*draws));
    AtomicWrite(folders_.results / "evaluation/matrix.json", FormatTables(tables_, TableFormat::kJson));
  }

  const Matrix& matrix_;
  PlanFolders folders_;
  JobFolders job_folders_;
  int at_once_;
  ContentHashes hashes_;
  std::vector<JobRecord> done_;
  std::vector<Table> tables_;
};

// Also when notes are not wanted. The first that failed: others may have needed it.
void ReportFailed(const std::vector<JobRecord>& jobs, const fs::path& folder) {
  const auto has_failed = [](const JobRecord& job) { return !job.HasSucceeded(); };
  const auto first = std::find_if(jobs.begin(), jobs.end(), has_failed);
  if (first == jobs.end()) return;
  PrintError(fmt::format("{} of {} jobs failed or were not run, first {}: {}; their logs are in {}",
                         std::count_if(jobs.begin(), jobs.end(), has_failed), jobs.size(), first->name,
                         first->reason, (folder / "jobs").string()));
}

bool HasFailed(const std::vector<JobRecord>& jobs) {
  return std::any_of(jobs.begin(), jobs.end(), [](const JobRecord& job) { return !job.HasSucceeded(); });
}

// The folder's own description of itself.
void WriteReadme(const fs::path& folder) {
  AtomicWrite(folder / "README.txt", "");
  std::string text = "Results of `armature reproduce`.\n\n";
  for (const auto& [name, meaning] : ListFiles(folder)) text += fmt::format("{:<18}{}\n", name, meaning);
  AtomicWrite(folder / "README.txt", text);
}

std::string WhereResultsAre(const ReproductionFolder& results, const std::vector<JobRecord>& jobs,
                            double seconds) {
  const auto count = [&](JobStatus status) {
    return std::count_if(jobs.begin(), jobs.end(),
                         [&](const JobRecord& job) { return job.status == status; });
  };
  std::string text = fmt::format(
      "\n{} jobs in {:.0f} s: {} done, {} used again, {} failed, {} not run\nResults: {} (also {})\n",
      jobs.size(), seconds, count(JobStatus::kDone), count(JobStatus::kReused), count(JobStatus::kFailed),
      count(JobStatus::kNotRun), results.folder().string(), results.latest().string());
  for (const auto& [name, meaning] : ListFiles(results.folder()))
    text += fmt::format("  {:<18}{}\n", name, meaning);
  return text;
}

CommandHelp ReproduceHelp() {
  return {
      .description =
          "Does everything: renders the embedded sequences, learns the category models, runs every sequence "
          "under every variant of a matrix, times them against the baselines, retrieves CAD models, compares "
          "all with the truth, and shows it on one page. Runs go side by side on the machine's cores, "
          "timings alone.\n\n"
          "What was finished is not done again while the program, its configuration and the data are the "
          "same, so an interrupted call goes on where it was. A run that fails is told in the table with its "
          "reason; the rest goes on.\n\n"
          "With --rooms, or several sequences of your own, each of them is a room: variants are compared "
          "over "
          "rooms with 95 % intervals, paired with the first variant, and the worst rooms are told.",
      .files = {{"OUT/NAME/report.html", "the report"},
                {"OUT/NAME/tables.*", "all tables as txt, md, csv, tex and json"},
                {"OUT/NAME/README.txt", "what each of the other files is: runs, raw rows, pictures, logs"},
                {"OUT/latest", "points to the folder that was made last"}},
      .exit_status = {{"1", "also: a run or another part failed, the rest is there"}},
      .examples = {
          {"everything; some minutes", "armature reproduce"},
          {"is everything in place? within a minute", "armature reproduce --fast"},
          {"one sequence, two variants", "armature reproduce --only seq1,objects,paper"},
          {"six variants in 40 rooms",
           "armature reproduce --rooms configs/rooms/mixed.yaml --count 40 --variants "
           "default,fast,no_viewpoint_prior,no_floor,no_refinement,no_loop_closure"},
          {"a thousand rooms without pictures",
           "armature reproduce --rooms configs/rooms/mixed.yaml --count 1000 --lines-only --variants "
           "default"},
          {"a sequence of your own", "armature reproduce my_sequence --name mine"},
          {"several, with their own boxes and with those of a detector",
           "armature reproduce office kitchen --variants default --detections yolo --name mine"}}};
}

}  // namespace

int RunReproduce(const ReproduceArguments& arguments) {
  const TableFormat format = arguments.json ? TableFormat::kJson : TableFormatFromName(arguments.format);
  const auto start = std::chrono::steady_clock::now();
  const Matrix matrix = LoadMatrix(arguments);
  ReproductionFolder results(arguments.out, matrix.name);
  AtomicWrite(results.partial() / "config.yaml", MatrixYaml(matrix));
  Reproduction reproduction(matrix, arguments, results);
  try {
    reproduction.Run();
  } catch (const Interrupted&) {
    throw Interrupted({results.partial().string() + ", from where the same command goes on"});
  }
  CollectPictures(results.partial(), matrix);
  WriteAllTables(results.partial(), reproduction.tables(), reproduction.done());
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  WriteEnvironment(results.partial(), seconds, reproduction.done());
  WriteReadme(results.partial());
  const std::string text = FormatAllTables(reproduction.tables(), reproduction.main_evaluations(), format);
  results.Publish();
  PrintResult(text);
  if (format == TableFormat::kText) PrintResult(WhereResultsAre(results, reproduction.done(), seconds));
  ReportFailed(reproduction.done(), results.folder());
  return HasFailed(reproduction.done()) ? 1 : 0;
}

void AddReproduceCommand(CLI::App& app, int& exit_status) {
  const auto arguments = std::make_shared<ReproduceArguments>();
  ReproduceArguments& a = *arguments;
  CLI::App* reproduce =
      app.add_subcommand("reproduce", "Run a matrix of sequences and variants, time, evaluate and report it");
  Describe(*reproduce, ReproduceHelp());
  BeginSection(*reproduce, "What is run");
  reproduce
      ->add_option(
          "SEQUENCE", a.sequences,
          "sequence folders instead of the matrix's; categories are then those of --categories or CONFIGS")
      ->type_name("DIR");
  reproduce
      ->add_option("--rooms", a.rooms,
                   "rooms drawn from a recipe (datasets/README.md) instead of the matrix's sequences")
      ->type_name("FILE");
  reproduce->add_option("--count", a.count, "so many rooms (40)")->check(CLI::PositiveNumber)->type_name("N");
  CLI::Option& split =
      KnownValues(*reproduce
                       ->add_option("--split", a.split,
                                    "which rooms: development, to be looked at as often as you "
                                    "like, or check, only to report (development)")
                       ->type_name("NAME"),
                  {kRoomSplits.begin(), kRoomSplits.end()});
  reproduce->add_option("--seed", a.seed, "rooms of this seed instead of a split's")
      ->excludes(&split)
      ->type_name("N");
  reproduce
      ->add_option("--collection", a.collections, "CAD models to furnish rooms with, may be given repeatedly")
      ->type_name("DIR")
      ->allow_extra_args(false);
  reproduce->add_flag("--lines-only", a.lines_only,
                      "rooms without pictures, but with the lines that the detector would find in them: far "
                      "quicker, for rooms by the thousand");
  reproduce
      ->add_option(
          "--variants", a.variants,
          "instead of the matrix's: names of its variants, presets and ablations; the first is what the "
          "others are compared with")
      ->type_name("NAME")
      ->delimiter(',')
      ->allow_extra_args(false);
  reproduce
      ->add_option("--detections", a.detections,
                   "run all of these with the boxes of another detector, too, DIR/<sequence>.csv; repeatable")
      ->type_name("DIR")
      ->allow_extra_args(false);
  reproduce
      ->add_option(
          "--jitter", a.jitter,
          "repeat each run so often with changes that must not matter (run --jitter): how far do results "
          "move?")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  reproduce->add_option("--config", a.config, "the matrix (CONFIGS/reproduce.yaml, which explains its keys)")
      ->type_name("FILE");
  reproduce->add_flag("--fast", a.fast,
                      "few frames, as the matrix's key `fast` says: is everything in place?");
  reproduce
      ->add_option(
          "--only", a.only,
          "only these sequences and variants (all where none is named) and timings; results go to NAME-only")
      ->type_name("NAME")
      ->delimiter(',')
      ->allow_extra_args(false);
  reproduce
      ->add_option("--seeds", a.seeds,
                   "draws of each scene, for mean and spread: other objects, clutter and noise")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  reproduce->add_option("--cad", a.cad, "annotated CAD models, for retrieval (the matrix's)")
      ->type_name("DIR");
  reproduce->add_option("--categories", a.categories, "folder of category models; none is learnt then")
      ->type_name("DIR");
  reproduce->add_option("--data", a.data, "where scenes are rendered to, once (the matrix's)")
      ->type_name("DIR");
  reproduce->add_option("--configs", a.configs, "CONFIGS: folder of presets and categories")
      ->type_name("DIR");
  reproduce->add_option("--jobs", a.jobs, "how many runs at once (a core each); timings are always alone")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  BeginSection(*reproduce, "Output");
  reproduce->add_option("--out", a.out, "folder of all results")->type_name("DIR")->capture_default_str();
  reproduce->add_option("--name", a.name, "of the folder in it (the matrix's)")->type_name("NAME");
  AddFormatArguments(*reproduce, a.format, a.json);
  reproduce->callback([arguments, &exit_status] { exit_status = RunReproduce(*arguments); });
}

}  // namespace armature
