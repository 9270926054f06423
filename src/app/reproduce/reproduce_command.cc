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
#include "base/progress.h"
#include "cli/data_folders.h"
#include "cli/help.h"
#include "cli/printed_tables.h"
#include "io/atomic_write.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

Matrix LoadMatrix(const ReproduceArguments& a) {
  Matrix matrix = ReadMatrix(a.config.empty() ? ConfigsFolder(a.configs) / "reproduce.yaml" : a.config,
                             {.fast = a.fast, .has_own_sequences = !a.sequences.empty()});
  if (!a.data.empty()) matrix.data = a.data;
  if (!a.cad.empty()) matrix.cad = fs::absolute(a.cad).lexically_normal();
  if (!a.sequences.empty()) ReplaceSequences(a.sequences, matrix);
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
void RemoveOtherRuns(const fs::path& results, const std::vector<Job>& jobs) {
  std::error_code absent;
  for (const auto& variant : fs::directory_iterator(results / "runs", absent)) {
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
    RemoveOtherRuns(folders_.results, runs);
    Do("runs and timings", runs);
    Do("evaluation", PlanEvaluation(matrix_, folders_, done_));
    WriteTables();
    Do("report", {PlanReport(matrix_, folders_, done_, {"evaluation/matrix.json"})});
  }

  const std::vector<JobRecord>& done() const { return done_; }
  const std::vector<Table>& tables() const { return tables_; }

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

  // None where nothing was evaluated, or that failed.
  std::optional<MatrixEvaluation> ReadEvaluation() const {
    const bool is_done = std::any_of(done_.begin(), done_.end(), [](const JobRecord& job) {
      return job.name == kAccuracyJob && job.HasSucceeded();
    });
    if (!is_done) return std::nullopt;
    const fs::path file = folders_.results / kAccuracyJob / "records.json";
    return MatrixEvaluation{file, ReadEvaluationRecords(file)};
  }

  // Those of the matrix itself; the rest are the evaluation's and the benchmarks'.
  void WriteTables() {
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
          "reason; the rest goes on.",
      .files = {{"OUT/NAME/report.html", "the report"},
                {"OUT/NAME/tables.*", "all tables as txt, md, csv, tex and json"},
                {"OUT/NAME/README.txt", "what each of the other files is: runs, raw rows, pictures, logs"},
                {"OUT/latest", "points to the folder that was made last"}},
      .exit_status = {{"1", "also: a run or another part failed, the rest is there"}},
      .examples = {{"everything; some minutes", "armature reproduce"},
                   {"is everything in place? within a minute", "armature reproduce --fast"},
                   {"one sequence, two variants", "armature reproduce --only seq1,objects,paper"},
                   {"a sequence of your own", "armature reproduce my_sequence --name mine"}}};
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
  results.Publish();
  PrintResult(FormatTables(reproduction.tables(), format));
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
