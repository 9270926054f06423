// SPDX-License-Identifier: BSD-3-Clause
#include "eval/budget/true_lines.h"

#include "io/segments_csv.h"
#include "io/stamped_rows.h"
#include "truth/sequence_truth.h"

namespace armature {
namespace {

constexpr double kShortestLine = 10;  // pixels: line detectors drop what is shorter

Segment VisiblePart(const CsvRow& row) {
  const Eigen::Vector2d p1(row.Number("x1"), row.Number("y1")), p2(row.Number("x2"), row.Number("y2"));
  const Eigen::Vector2d middle = 0.5 * (p1 + p2), half = 0.5 * row.Number("visible") * (p2 - p1);
  return {middle - half, middle + half};
}

}  // namespace

SubstitutedFiles ReplaceLines(const std::filesystem::path& sequence) {
  const std::vector<ImageEntry> images = ReadImageList(sequence / "rgb.txt");
  std::vector<double> times;
  for (const ImageEntry& image : images) times.push_back(image.timestamp);
  const ImageStamps stamps(images);
  std::vector<std::vector<Segment>> lines(images.size());
  const CsvTable table(sequence / kTrueEdgesFile, {"timestamp", "x1", "y1", "x2", "y2", "visible"});
  for (const CsvRow& row : table.rows()) {
    const Segment line = VisiblePart(row);
    if (line.length() >= kShortestLine) lines[stamps.FindImage(row)].push_back(line);
  }
  return {{"segments.csv", SegmentsText(times, lines)}};
}

}  // namespace armature
