// SPDX-License-Identifier: BSD-3-Clause
#include "app/reproduce/plan_jobs.h"

#include <algorithm>

#include "app/reproduce/job_planner.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRoomTables = "rooms,room_differences,stability,worst_rooms,room_factors,room_groups";

bool HasSucceeded(const std::vector<JobRecord>& done, const std::string& name) {
  return std::any_of(done.begin(), done.end(),
                     [&](const JobRecord& record) { return record.name == name && record.HasSucceeded(); });
}

// Of these variants those with a run that has succeeded, below that folder.
std::vector<std::string> WithRuns(const std::vector<std::string>& variants,
                                  const std::vector<JobRecord>& done, const std::string& below = "runs/") {
  std::vector<std::string> with_runs;
  for (const std::string& variant : variants) {
    const bool has_run = std::any_of(done.begin(), done.end(), [&](const JobRecord& record) {
      return record.name.starts_with(below + variant + "/") && record.HasSucceeded();
    });
    if (has_run) with_runs.push_back(below + variant);
  }
  return with_runs;
}

// Of the repeats with a run that has succeeded.
std::vector<std::string> JitteredRuns(const Matrix& matrix, const std::vector<JobRecord>& done) {
  std::vector<std::string> names;
  for (const std::string& variant : RunVariants(matrix)) {
    for (int jitter = 1; jitter <= matrix.jitter; ++jitter)
      names.push_back(variant + "-" + std::to_string(jitter));
  }
  return WithRuns(names, done, "jitter/");
}

// Sequences of one's own are rooms, too.
bool IsOverRooms(const Matrix& matrix) {
  return matrix.rooms || matrix.sequences.size() > 1 || matrix.jitter > 0;
}

bool HaveTruth(const Matrix& matrix) {
  const std::vector<MatrixSequence> sequences = ListSequences(matrix);
  return std::any_of(sequences.begin(), sequences.end(), [](const MatrixSequence& sequence) {
    return fs::exists(sequence.folder / "groundtruth.txt") || fs::exists(sequence.folder / "objects_gt.csv");
  });
}

}  // namespace

std::vector<Job> PlanRuns(const Matrix& matrix, const PlanFolders& folders) {
  const JobPlanner planner(matrix, folders);
  std::vector<Job> jobs;
  for (int draw = 1; draw <= matrix.seeds && !matrix.scenes.empty(); ++draw)
    jobs.push_back(planner.Data(draw));
  for (const LearntCategory& category : matrix.categories) jobs.push_back(planner.Category(category));
  if (!matrix.retrieval.empty()) jobs.push_back(planner.Library());
  const std::vector<MatrixSequence> sequences = ListSequences(matrix);
  for (const MatrixSequence& sequence : sequences) {
    if (sequence.room) jobs.push_back(planner.Room(sequence));
  }
  for (int jitter = 0; jitter <= matrix.jitter; ++jitter) {
    for (const Variant& variant : matrix.variants) {
      if (!variant.IsRun()) continue;
      for (const MatrixSequence& sequence : sequences) jobs.push_back(planner.Run(variant, sequence, jitter));
    }
  }
  for (const Timing& timing : matrix.timings) jobs.push_back(planner.Bench(timing));
  return jobs;
}

std::vector<Job> PlanEvaluation(const Matrix& matrix, const PlanFolders& folders,
                                const std::vector<JobRecord>& done) {
  const JobPlanner planner(matrix, folders);
  std::vector<Job> jobs;
  const std::vector<std::string> variants = WithRuns(RunVariants(matrix), done);
  const std::vector<std::string> retrieved = WithRuns(matrix.retrieval, done);
  const bool has_truth = HaveTruth(matrix);
  if (has_truth && !variants.empty() && !matrix.rooms)
    jobs.push_back(planner.Evaluation(kAccuracyJob, variants, planner.CadArguments()));
  if (has_truth && !variants.empty() && IsOverRooms(matrix)) {
    std::vector<std::string> runs = variants;
    for (std::string& run : JitteredRuns(matrix, done)) runs.push_back(std::move(run));
    jobs.push_back(planner.Evaluation(kRoomsJob, runs, {"--tables", kRoomTables}));
  }
  if (has_truth && !retrieved.empty()) {
    jobs.push_back(planner.Evaluation("evaluation/retrieval", retrieved,
                                      {"--library", kLibraryFile, "--tables", "retrieval,each_query"}));
    jobs.back().inputs.emplace_back(kLibraryFile);
  }
  if (HasSucceeded(done, "library") && matrix.library_every > 0) {
    jobs.push_back(planner.Evaluation(
        "evaluation/library", {},
        {"--library", kLibraryFile, "--tables", "library", "--every", std::to_string(matrix.library_every)}));
    jobs.back().inputs.emplace_back(kLibraryFile);
  }
  return jobs;
}

Job PlanReport(const Matrix& matrix, const PlanFolders& folders, const std::vector<JobRecord>& done,
               const ReportedFiles& files) {
  const JobPlanner planner(matrix, folders);
  Job job{.name = "report", .outputs = {"report.html"}, .inputs = {planner.CategoriesInput()}};
  std::vector<std::string> call{"report"};
  const auto add = [&](const std::string& option, const std::string& input) {
    if (!option.empty()) call.push_back(option);
    call.push_back(input);
    job.inputs.emplace_back(input);
  };
  const std::vector<std::string> all = WithRuns(RunVariants(matrix), done);
  for (const std::string& run : files.runs.empty() ? all : files.runs) add("", run);
  planner.AddSequences(job);
  for (const JobRecord& record : done) {
    if (record.name.starts_with("evaluation/") && record.HasSucceeded()) add("--eval", record.name);
    if (record.name.starts_with("timings/") && record.HasSucceeded()) add("--bench", record.name);
  }
  for (const std::string& table : files.tables) add("--table", table);
  if (HasSucceeded(done, "library")) add("--library", kLibraryFile);
  call.insert(call.end(), {"--title", "Armature: " + matrix.name, "--out", "report.html"});
  job.commands = {planner.Call(call)};
  return job;
}

}  // namespace armature
