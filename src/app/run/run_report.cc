// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/run_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "base/statistics.h"
#include "io/json_file.h"
#include "io/text_table.h"

namespace armature {
namespace {

// In the order in which they are worth a look.
const std::vector<std::pair<std::string, std::string>> kFiles = {
    {"summary.json", "counts, stage times, versions, machine"},
    {"trajectory.txt", "camera poses T_world_camera (TUM), metric"},
    {"odometry_scaled.txt", "the odometry alone in the same frame and scale (TUM)"},
    {"objects.csv", "the map: a row an object"},
    {"shape_evidence.csv", "what the images say of each object's shape: `armature retrieve` weighs by it"},
    {"objects_odometry.csv", "the same objects placed by odometry alone"},
    {"observations.csv", "a row a detection: status, T_camera_object, shape"},
    {"associations.csv", "which line segment explains which edge"},
    {"timings.csv", "milliseconds of each stage, a row a frame"},
    {"config.yaml", "all options as they were"},
    {"overlays", "a picture a frame: boxes, segments, wireframes"},
};

Cell MedianCell(const SequenceRunResult& result, const std::string& name) {
  for (const StageStatistics::Stage& stage : result.statistics.stages()) {
    if (stage.name == name) return NumberCell(Quantile(stage.milliseconds, 0.5), 2);
  }
  return NoCell();
}

Table RunTable(const std::vector<SequenceRunResult>& results) {
  Table table;
  table.columns = {"sequence",   "frames",       "skipped",          "detections",
                   "placed",     "lines [ms]",   "association [ms]", "optimization [ms]",
                   "total [ms]", "latency [ms]", "frames/s"};
  for (const SequenceRunResult& result : results) {
    const RunCounts& counts = result.counts;
    table.rows.push_back(
        {TextCell(result.sequence), CountCell(counts.frames), CountCell(counts.skipped_images),
         CountCell(counts.detections), CountCell(counts.observations.front()), MedianCell(result, "lines"),
         MedianCell(result, "association"), MedianCell(result, "optimization"), MedianCell(result, "total"),
         NumberCell(Quantile(result.pace.latency_ms, 0.5), 2), NumberCell(result.pace.frames_per_second, 0)});
  }
  table.notes = {
      "placed: detections with status ok. Times: median of a frame, all its objects, one thread a stage;",
      "total: every stage but loading the image. latency: from the loaded image to the result, median.",
      "frames/s: over all frames, with loading them and writing the rows."};
  return table;
}

Table MapTable(const std::vector<SequenceRunResult>& results) {
  Table table;
  table.columns = {"sequence",       "objects",       "scale [m/unit]", "+- [%]",
                   "first [m/unit]", "last [m/unit]", "solve [ms]",     "back end [ms/frame]"};
  for (const SequenceRunResult& result : results) {
    table.rows.push_back({TextCell(result.sequence)});
    std::vector<Cell>& row = table.rows.back();
    if (!result.map) {
      row.resize(table.columns.size(), NoCell());
      continue;
    }
    const MapSummary& map = *result.map;
    row.push_back(CountCell(map.objects));
    row.push_back(NumberCell(map.scale, 4));
    row.push_back(map.scale_sigma ? NumberCell(100 * *map.scale_sigma, 1) : NoCell());
    row.push_back(NumberCell(map.first_scale, 4));
    row.push_back(NumberCell(map.last_scale, 4));
    row.push_back(NumberCell(map.solve_ms, 0));
    row.push_back(NumberCell(BackEndMilliseconds(result.counts, map), 2));
  }
  table.notes = {
      "scale: of the odometry, from the objects; +-: its standard deviation as the graph has it; first, "
      "last: at both ends of the sequence. solve: the map of all frames, at the end. back end: that and the "
      "map while frames come in, over the frames. A dash: no odometry, no map."};
  return table;
}

std::string FilesText(const std::filesystem::path& folder) {
  std::string text;
  for (const auto& [name, meaning] : kFiles) {
    if (std::filesystem::exists(folder / name)) text += fmt::format("  {:<20} {}\n", name, meaning);
  }
  return text;
}

}  // namespace

std::string RunReportText(const std::vector<SequenceRunResult>& results) {
  std::string text = FormatTable(RunTable(results), TableFormat::kText);
  text += "\n";
  text += FormatTable(MapTable(results), TableFormat::kText);
  text += "\nResults:\n";
  for (const SequenceRunResult& result : results) {
    text += fmt::format("  {}\n", result.folder.string());
    if (!result.video.empty()) text += fmt::format("  {}: its overlays\n", result.video.string());
  }
  text += results.size() == 1 ? "\nIn it:\n" : "\nIn each of them:\n";
  return text + FilesText(results.front().folder);
}

std::string RunReportJson(const std::vector<SequenceRunResult>& results) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const SequenceRunResult& result : results) {
    json.push_back({{"sequence", result.sequence},
                    {"folder", result.folder.string()},
                    {"summary", ReadJson(result.folder / "summary.json", "run it again")}});
  }
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace armature
