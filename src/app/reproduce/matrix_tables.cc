// SPDX-License-Identifier: BSD-3-Clause
#include "app/reproduce/matrix_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/reproduce/job_records.h"
#include "base/errors.h"
#include "base/text.h"

namespace armature {
namespace {

// The run that has a variant's results; one placed by odometry has those of another variant's run.
std::string FindRunFolder(const Variant& variant, const std::string& sequence) {
  return fmt::format("runs/{}/{}", variant.IsRun() ? variant.name : variant.odometry_of, sequence);
}

const JobRecord* FindJob(const std::vector<JobRecord>& jobs, const std::string& name) {
  const auto found =
      std::find_if(jobs.begin(), jobs.end(), [&](const JobRecord& job) { return job.name == name; });
  return found == jobs.end() ? nullptr : &*found;
}

// By its folder: a sequence's name need not be that of its folder.
const EvaluatedRunRecord& FindRun(const MatrixEvaluation& evaluation, const std::string& folder) {
  for (const EvaluatedRunRecord& run : evaluation.records.runs) {
    if (run.folder == folder) return run;
  }
  throw InputError(
      fmt::format("{}: has no run in 'folder' {}, which has succeeded; remove the file's folder "
                  "and run 'armature reproduce' again",
                  evaluation.file.string(), folder));
}

// Null where the sequence has no truth of the kind, or the run no result.
struct VariantRecords {
  const ObjectRecord* objects = nullptr;
  const TrajectoryRecord* cameras = nullptr;
  const ViewRecord* views = nullptr;
};

template <typename Record, typename Predicate>
const Record* FindRecord(const std::vector<Record>& records, const EvaluatedRunRecord& run,
                         const Predicate& is_wanted) {
  for (const Record& record : records) {
    if (record.sequence == run.sequence && record.run == run.run && is_wanted(record)) return &record;
  }
  return nullptr;
}

VariantRecords FindRecords(const EvaluationRecords& records, const EvaluatedRunRecord& run,
                           bool by_odometry) {
  VariantRecords found;
  found.objects = FindRecord(records.objects, run, [&](const ObjectRecord& record) {
    return !record.category && record.matched_by == MatchedBy::kDistance &&
           (record.approach == Approach::kOdometryOnly) == by_odometry;
  });
  found.cameras = FindRecord(records.trajectories, run, [&](const TrajectoryRecord& record) {
    return record.alignment == AlignmentKind::kFirstPose &&
           record.trajectory == (by_odometry ? TrajectoryKind::kOdometryScaled : TrajectoryKind::kTrajectory);
  });
  if (by_odometry) return found;
  found.views = FindRecord(records.views, run,
                           [](const ViewRecord& record) { return !record.category && !record.only_ok; });
  return found;
}

// A run that was evaluated has records of all that its sequence has the truth of: dashes would hide a wrong
// name.
void CheckEvaluated(const MatrixEvaluation& evaluation, const EvaluatedRunRecord& run,
                    const std::filesystem::path& sequence) {
  const auto is_any = [](const auto&) { return true; };
  const bool cameras = std::filesystem::exists(sequence / "groundtruth.txt");
  const bool objects = cameras && std::filesystem::exists(sequence / "objects_gt.csv");
  const bool lacks_cameras = cameras && FindRecord(evaluation.records.trajectories, run, is_any) == nullptr;
  const bool lacks_objects = objects && FindRecord(evaluation.records.objects, run, is_any) == nullptr;
  if (!lacks_cameras && !lacks_objects) return;
  throw InputError(
      fmt::format("{}: has no {} of run {} of sequence {}, of which {} has the truth; remove the "
                  "file's folder and run 'armature reproduce' again",
                  evaluation.file.string(), lacks_cameras ? "cameras" : "objects", Quoted(run.run),
                  Quoted(run.sequence), sequence.string()));
}

VariantRecords FindRecords(const std::vector<JobRecord>& jobs, const MatrixEvaluation* evaluation,
                           const Variant& variant, const MatrixSequence& sequence) {
  const std::string folder = FindRunFolder(variant, sequence.name);
  const JobRecord* job = FindJob(jobs, folder);
  if (evaluation == nullptr || job == nullptr || !job->HasSucceeded()) return {};
  const EvaluatedRunRecord& run = FindRun(*evaluation, folder);
  CheckEvaluated(*evaluation, run, sequence.folder);
  return FindRecords(evaluation->records, run, !variant.IsRun());
}

// What became of the job.
std::string DescribeOutcome(const JobRecord* job) {
  if (job == nullptr) return StatusName(JobStatus::kNotRun);
  return job->HasSucceeded() ? "done" : fmt::format("{}: {}", StatusName(job->status), job->reason);
}

template <typename Record>
Cell Count(const Record* record, long Record::*count) {
  return record == nullptr ? NoCell() : CountCell(record->*count);
}

template <typename Record>
Cell Number(const Record* record, std::optional<double> Record::*value, int digits) {
  return record == nullptr ? NoCell() : NumberCell(record->*value, digits);
}

Cell ViewsWithin15Deg(const ViewRecord* record) {
  return record == nullptr ? NoCell() : ShareCell(record->views_within_15_deg_share, record->detections);
}

std::vector<Cell> MatrixRow(const std::string& sequence, const Variant& variant, const VariantRecords& r,
                            const JobRecord* job) {
  return {TextCell(sequence),
          TextCell(variant.about),
          Count(r.objects, &ObjectRecord::observed),
          Count(r.objects, &ObjectRecord::found),
          Count(r.objects, &ObjectRecord::spurious),
          Number(r.objects, &ObjectRecord::object_error_best_m, 4),
          Number(r.objects, &ObjectRecord::object_error_mean_m, 4),
          Number(r.objects, &ObjectRecord::object_error_worst_m, 4),
          Number(r.objects, &ObjectRecord::azimuth_mean_deg, 2),
          Number(r.cameras, &TrajectoryRecord::ate_rmse_m, 4),
          ViewsWithin15Deg(r.views),
          TextCell(DescribeOutcome(job))};
}

std::vector<std::string> MatrixNotes() {
  return {
      "found, best, average, worst, spurious, azimuth: of the objects of the map against the true ones, as "
      "in the table of objects; cameras: rmse of their positions, the first pose aligned; views within 15 "
      "deg: share of all detections whose single view has the azimuth right.",
      "odometry only: the same run's objects, placed by the odometry alone with the map's scale and "
      "identities."};
}

// Of the draws of a family.
struct Spread {
  std::vector<double> values;

  double Mean() const {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  }
  std::optional<double> Deviation() const {
    if (values.size() < 2) return std::nullopt;
    double sum = 0;
    for (const double value : values) sum += (value - Mean()) * (value - Mean());
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
  }
};

void PushDraws(const Matrix& matrix, const std::vector<JobRecord>& jobs, const MatrixEvaluation* evaluation,
               const std::string& scene, const Variant& variant, Table& table) {
  Spread error;
  long found = 0, observed = 0, spurious = 0;
  for (const MatrixSequence& sequence : ListSequences(matrix)) {
    if (sequence.family != scene) continue;
    const ObjectRecord* objects = FindRecords(jobs, evaluation, variant, sequence).objects;
    if (objects == nullptr) continue;
    if (objects->object_error_mean_m) error.values.push_back(*objects->object_error_mean_m);
    found += objects->found;
    observed += objects->observed;
    spurious += objects->spurious;
  }
  auto& row = table.rows.emplace_back();
  row = {TextCell(scene), TextCell(variant.about), CountCell(static_cast<long>(error.values.size()))};
  if (error.values.empty()) {
    row.resize(table.columns.size(), NoCell());
    return;
  }
  const auto [least, most] = std::minmax_element(error.values.begin(), error.values.end());
  for (const Cell& cell :
       {NumberCell(error.Mean(), 4), NumberCell(error.Deviation(), 4), NumberCell(*least, 4),
        NumberCell(*most, 4), CountCell(found), CountCell(observed), CountCell(spurious)})
    row.push_back(cell);
}

}  // namespace

Table MatrixTable(const Matrix& matrix, const std::vector<JobRecord>& jobs,
                  const MatrixEvaluation* evaluation) {
  Table table{.title = "Sequences and variants",
              .columns = {"sequence", "variant", "observed", "found", "spurious", "best [m]", "average [m]",
                          "worst [m]", "azimuth [deg]", "cameras [m]", "views within 15 deg [%]", "outcome"},
              .rows = {},
              .notes = MatrixNotes(),
              .name = "matrix"};
  for (const MatrixSequence& sequence : ListSequences(matrix)) {
    for (const Variant& variant : matrix.variants)
      table.rows.push_back(MatrixRow(sequence.name, variant, FindRecords(jobs, evaluation, variant, sequence),
                                     FindJob(jobs, FindRunFolder(variant, sequence.name))));
  }
  return table;
}

std::optional<Table> DrawsTable(const Matrix& matrix, const std::vector<JobRecord>& jobs,
                                const MatrixEvaluation* evaluation) {
  if (matrix.seeds < 2 || matrix.scenes.empty()) return std::nullopt;
  Table table{
      .title = fmt::format("Objects' average error over {} draws of each scene [m]", matrix.seeds),
      .columns = {"scene", "variant", "draws", "mean", "spread", "least", "most", "found", "observed",
                  "spurious"},
      .rows = {},
      .notes = {"mean, spread: of the draws' average errors; spread: their standard deviation (n - 1). "
                "found, observed, spurious: sums. Each draw has other objects, clutter and noise."},
      .name = "draws"};
  for (const std::string& scene : matrix.scenes) {
    for (const Variant& variant : matrix.variants) PushDraws(matrix, jobs, evaluation, scene, variant, table);
  }
  return table;
}

Table JobTable(const std::vector<JobRecord>& records) {
  Table table{
      .title = "Jobs",
      .columns = {"job", "outcome", "time [s]", "reason"},
      .rows = {},
      .notes = {"time: of its calls, when they were made; jobs run beside each other, those of timings and "
                "data alone. reused: an earlier run of the same program on the same inputs."},
      .name = "jobs"};
  for (const JobRecord& record : records) {
    table.rows.push_back({TextCell(record.name), TextCell(StatusName(record.status)),
                          record.seconds > 0 ? NumberCell(record.seconds, 1) : NoCell(),
                          TextCell(record.reason)});
  }
  return table;
}

}  // namespace armature
