// SPDX-License-Identifier: BSD-3-Clause
#include "bench/detector_table.h"

#include <fmt/format.h>

#include <optional>

#include "io/stage_statistics.h"

namespace armature {
namespace {

std::optional<double> QuantileOf(const std::vector<double>& values, double fraction) {
  return Quantile({values.begin(), values.end()}, fraction);
}

Cell RecallCell(const EdgeRecall& recall) {
  if (recall.visible <= 0) return NoCell();
  return NumberCell(100 * recall.covered / recall.visible, 1);
}

std::vector<Cell> RowOf(const DetectorTiming& timing) {
  std::vector<Cell> row{
      TextCell(timing.options.detector), TextCell(timing.options.published ? "published" : "tuned"),
      NumberCell(QuantileOf(timing.milliseconds, 0.5), 2),
      NumberCell(QuantileOf(timing.milliseconds, 0.9), 2), NumberCell(QuantileOf(timing.segments, 0.5), 0)};
  EdgeRecall all;
  for (const auto& [category, recall] : timing.recall) {
    row.push_back(RecallCell(recall));
    all.visible += recall.visible;
    all.covered += recall.covered;
  }
  row.push_back(RecallCell(all));
  return row;
}

}  // namespace

Table DetectorTable(const std::string& sequence, size_t images, const std::vector<DetectorTiming>& timings) {
  Table table;
  table.title = fmt::format("{}: line detectors, {} images", sequence, images);
  table.columns = {"detector", "parameters", "median [ms]", "p90 [ms]", "segments"};
  if (!timings.empty()) {
    for (const auto& [category, recall] : timings.front().recall) {
      table.columns.push_back(fmt::format("{} recall [%]", category));
    }
  }
  table.columns.push_back("all recall [%]");
  for (const DetectorTiming& timing : timings) table.rows.push_back(RowOf(timing));
  const EdgeTolerance tolerance;
  const LineOptions options;
  table.notes = {
      fmt::format("ms: one thread, wall clock an image: detection in the whole image, dropping what is "
                  "shorter than {} px, "
                  "undistorting; images are loaded before, detectors take turns, warm-up left out.",
                  options.min_length),
      "segments: median an image.",
      fmt::format(
          "recall: share of the length of the detected objects' own edges, in the image and not hidden, "
          "beside "
          "which some segment runs within {} px and {} degrees; a dash without edges_gt.csv or known CAD "
          "models (--cad).",
          tolerance.distance, tolerance.angle_deg)};
  return table;
}

}  // namespace armature
