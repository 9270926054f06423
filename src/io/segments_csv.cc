// SPDX-License-Identifier: BSD-3-Clause
#include "io/segments_csv.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "base/number_format.h"
#include "io/atomic_write.h"
#include "io/csv.h"
#include "io/stamped_rows.h"

namespace armature {

std::vector<std::vector<Segment>> ReadSegments(const std::filesystem::path& file,
                                               const std::vector<ImageEntry>& images) {
  const CsvTable table(file, {"timestamp", "x1", "y1", "x2", "y2"});
  table.CheckColumnsKnown({"timestamp", "x1", "y1", "x2", "y2"});
  const ImageStamps stamps(images);
  std::vector<std::vector<Segment>> segments(images.size());
  for (const CsvRow& row : table.rows()) {
    const Segment segment{{row.Number("x1"), row.Number("y1")}, {row.Number("x2"), row.Number("y2")}};
    if (segment.length() <= 0)
      throw InputError(row.At("both ends of the segment are one point; remove the row"));
    segments[stamps.FindImage(row)].push_back(segment);
  }
  for (std::vector<Segment>& of_image : segments) {
    std::stable_sort(of_image.begin(), of_image.end(),
                     [](const Segment& a, const Segment& b) { return a.length() > b.length(); });
  }
  return segments;
}

std::string SegmentsText(const std::vector<double>& stamps,
                         const std::vector<std::vector<Segment>>& segments) {
  std::string text = "timestamp,x1,y1,x2,y2\n";
  for (size_t i = 0; i < stamps.size(); ++i) {
    for (const Segment& segment : segments[i]) {
      text += fmt::format("{},{},{},{},{}\n", Fixed(stamps[i], 6), Fixed(segment.p1.x(), 2),
                          Fixed(segment.p1.y(), 2), Fixed(segment.p2.x(), 2), Fixed(segment.p2.y(), 2));
    }
  }
  return text;
}

void WriteSegments(const std::filesystem::path& file, const std::vector<double>& stamps,
                   const std::vector<std::vector<Segment>>& segments) {
  WriteFile(file, SegmentsText(stamps, segments));
}

}  // namespace armature
