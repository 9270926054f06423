// SPDX-License-Identifier: BSD-3-Clause
#include "io/run_summary.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/statistics.h"
#include "io/build_info.h"

namespace armature {
namespace {

using Json = nlohmann::ordered_json;

double Rounded(double value) { return std::round(value * 1000) / 1000; }

Json QuantileJson(const std::vector<double>& values, double fraction) {
  const std::optional<double> value = Quantile(values, fraction);
  return value ? Json(Rounded(*value)) : Json(nullptr);
}

Json StagesJson(const StageStatistics& statistics) {
  Json stages;
  for (const StageStatistics::Stage& stage : statistics.stages()) {
    stages[stage.name] = {{"median", QuantileJson(stage.milliseconds, 0.5)},
                          {"p90", QuantileJson(stage.milliseconds, 0.9)},
                          {"p99", QuantileJson(stage.milliseconds, 0.99)},
                          {"frames", stage.milliseconds.size()}};
  }
  return stages;
}

Json CountsJson(const RunCounts& counts) {
  Json observations;
  for (size_t i = 0; i < kAllStatuses.size(); ++i) {
    observations[std::string(StatusName(kAllStatuses[i]))] = counts.observations[i];
  }
  return {{"frames", counts.frames},
          {"skipped_images", counts.skipped_images},
          {"detections", counts.detections},
          {"segments", counts.segments},
          {"observations", observations}};
}

Json OdometryJson(const OdometryCoverage& coverage) {
  return {{"poses", coverage.poses},
          {"images", coverage.images},
          {"images_with_pose", coverage.images_with_pose},
          {"interpolated", coverage.interpolated},
          {"gaps", coverage.gaps},
          {"longest_gap_s", Rounded(coverage.longest_gap)}};
}

Json MapJson(const std::optional<MapSummary>& map, const RunCounts& counts) {
  if (!map) return nullptr;
  return {{"objects", map->objects},
          {"scale", map->scale},
          {"scale_sigma", map->scale_sigma ? Json(*map->scale_sigma) : Json(nullptr)},
          {"first_scale", map->first_scale},
          {"last_scale", map->last_scale},
          {"incremental_ms", Rounded(map->incremental_ms)},
          {"solve_ms", Rounded(map->solve_ms)},
          {"back_end_ms_per_frame", Rounded(BackEndMilliseconds(counts, *map))}};
}

Json PaceJson(const FramePace& pace) {
  return {{"latency_ms",
           {{"median", QuantileJson(pace.latency_ms, 0.5)},
            {"p90", QuantileJson(pace.latency_ms, 0.9)},
            {"p99", QuantileJson(pace.latency_ms, 0.99)}}},
          {"frames_per_second", Rounded(pace.frames_per_second)}};
}

Json SkippedJson(const RunCounts& counts) {
  Json skipped = Json::array();
  for (const SkippedImage& image : counts.skipped) {
    skipped.push_back({{"timestamp", image.timestamp}, {"reason", image.reason}});
  }
  return skipped;
}

}  // namespace

double BackEndMilliseconds(const RunCounts& counts, const MapSummary& map) {
  return (map.incremental_ms + map.solve_ms) / static_cast<double>(std::max(counts.frames, 1L));
}

std::string SummaryJson(const RunSummary& summary, const RunCounts& counts, const StageStatistics& statistics,
                        double wall_seconds) {
  const BuildInfo build = GetBuildInfo();
  const MachineInfo machine = GetMachineInfo();
  Json json;
  json["program"] = "armature";
  json["version"] = build.version;
  json["sequence"] = summary.sequence;
  if (!summary.sequence_folder.empty()) json["sequence_folder"] = summary.sequence_folder;
  if (!summary.detections.empty()) json["detections"] = summary.detections;
  if (summary.jitter > 0) json["jitter"] = summary.jitter;
  json["preset"] = summary.preset;
  json["threads"] = summary.threads;
  json["git"] = {{"commit", build.git_commit}, {"dirty", build.git_dirty}};
  json["versions"] = {
      {"opencv", build.opencv}, {"eigen", build.eigen}, {"ceres", build.ceres}, {"compiler", build.compiler}};
  json["machine"] = {{"cpu", machine.cpu}, {"cores", machine.cores}};
  json["counts"] = CountsJson(counts);
  json["odometry"] = OdometryJson(summary.odometry);
  json["map"] = MapJson(summary.map, counts);
  json["skipped"] = SkippedJson(counts);
  json["stages_ms"] = StagesJson(statistics);  // wall clock a frame; total is without load
  json["pace"] = PaceJson(summary.pace);
  json["wall_seconds"] = Rounded(wall_seconds);
  json["peak_memory_mb"] = Rounded(PeakMemoryMegabytes());
  json["complete"] = true;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void StageStatistics::Add(const StageTimes& times) {
  const std::array<double, 6> values{times.load,         times.lines,   times.association,
                                     times.optimization, times.mapping, times.total()};
  for (size_t i = 0; i < values.size(); ++i) stages_[i].milliseconds.push_back(values[i]);
}

}  // namespace armature
