// SPDX-License-Identifier: BSD-3-Clause
#include "eval/statistics/run_values.h"

#include <fmt/format.h>

#include <cmath>

#include "base/errors.h"
#include "base/microseconds.h"
#include "category/category_lookup.h"
#include "eval/trajectories/trajectory_metrics.h"
#include "eval/trajectories/unmatched_stamps.h"
#include "io/csv.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

constexpr double kOtherPace = 1.15;
constexpr const char* kLoad = "load";

std::string TimeName(const std::string& stage) { return "time: " + stage + " [ms]"; }

NamedValues CameraErrors(const fs::path& run, const std::vector<TimedPose>& truth,
                         const ObjectEvaluationOptions& options) {
  NamedValues errors{"camera position error [m]", 4, {}};
  // A run without odometry has a trajectory without poses.
  const fs::path file = run / "trajectory.txt";
  if (ReadTextLines(file).empty()) return errors;
  const std::vector<TimedPose> estimate = ReadTumTrajectory(file);
  const TrajectoryEvaluation evaluation = EvaluateTrajectory(
      estimate, truth,
      {.alignment = options.alignment, .first_n = options.first_n, .tolerance = options.tolerance});
  if (evaluation.poses.empty()) {
    throw InputError(
        fmt::format("{}: {}", file.string(), ExplainUnmatched(estimate, truth, options.tolerance)));
  }
  for (const PoseError& pose : evaluation.poses)
    errors.values[{"", Microseconds(pose.timestamp)}] = pose.position;
  return errors;
}

void AddObjectErrors(const RunResults& run, const SequenceTruth& truth,
                     const std::vector<CategoryModel>& models, const ObjectEvaluationOptions& options,
                     std::vector<NamedValues>& errors) {
  NamedValues centres{"object centre error [m]", 4, {}}, azimuths{"object azimuth error [deg]", 2, {}};
  const RunObjects objects = EvaluateRunObjects(run, truth, CollectSpecs(models), options);
  if (objects.maps.empty()) return;
  for (const EvaluatedObject& object : objects.maps.back().by_distance) {
    if (!object.error || object.true_id.empty()) continue;
    centres.values[{object.true_id}] = object.error->centre_m;
    azimuths.values[{object.true_id}] = std::abs(object.error->orientation.azimuth_deg);
  }
  errors.push_back(centres);
  errors.push_back(azimuths);
}

void AddViewErrors(const RunResults& run, const SequenceTruth& truth,
                   const std::vector<CategoryModel>& models, std::vector<NamedValues>& errors) {
  NamedValues azimuths{"single view azimuth error [deg]", 2, {}};
  NamedValues translations{"single view translation error [%]", 2, {}};
  for (const EvaluatedDetection& detection : EvaluateRun(run, truth, models, CadLibrary()).detections) {
    if (!detection.error) continue;
    const ValueKey key{detection.object, Microseconds(detection.timestamp), detection.index};
    azimuths.values[key] = detection.error->azimuth_deg;
    translations.values[key] = detection.error->translation_percent;
  }
  errors.push_back(azimuths);
  errors.push_back(translations);
}

}  // namespace

std::vector<NamedValues> ComputeRunErrors(const fs::path& run, const fs::path& truth,
                                          const std::vector<CategoryModel>& models,
                                          const ObjectEvaluationOptions& options) {
  std::vector<NamedValues> errors;
  if (!fs::exists(truth / "groundtruth.txt")) return errors;
  if (fs::exists(truth / "objects_gt.csv")) {
    const SequenceTruth sequence = LoadSequenceTruth(truth, CollectSpecs(models));
    const RunResults results = LoadRun(run);
    AddObjectErrors(results, sequence, models, options, errors);
    AddViewErrors(results, sequence, models, errors);
  }
  errors.push_back(CameraErrors(run, LoadTrueTrajectory(truth), options));
  return errors;
}

std::vector<NamedValues> ReadRunTimes(const fs::path& run) {
  const CsvTable table(run / "timings.csv", {"timestamp"});
  std::vector<NamedValues> times;
  for (const std::string stage : {"total", "lines", "association", "optimization", "mapping", kLoad}) {
    const std::string column = stage + "_ms";
    if (!table.HasColumn(column)) continue;
    NamedValues& values = times.emplace_back(NamedValues{TimeName(stage), 3, {}});
    for (const CsvRow& row : table.rows())
      values.values[{"", Microseconds(row.Number("timestamp"))}] = row.Number(column);
  }
  return times;
}

std::optional<std::string> PaceRemark(const std::vector<ComparedValues>& compared) {
  for (const ComparedValues& values : compared) {
    const auto difference = values.name == TimeName(kLoad) ? ComputeDifference(values) : std::nullopt;
    const auto mark = difference ? difference->mark : DifferenceMark::kTooFew;
    if (mark != DifferenceMark::kLower && mark != DifferenceMark::kHigher) continue;
    const double ratio = difference->median_b / difference->median_a;
    if (ratio < kOtherPace && ratio > 1 / kOtherPace) continue;
    return fmt::format(
        "loading the images took {:.2f} times as long in B: a busy or another machine, times do not compare",
        ratio);
  }
  return std::nullopt;
}

}  // namespace armature
