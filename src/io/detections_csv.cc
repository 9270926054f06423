// SPDX-License-Identifier: BSD-3-Clause
// detections.csv: what a detector and a viewpoint estimator say, a row a detection, angles in degrees.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "geometry/rotation.h"
#include "io/csv.h"
#include "io/sequence.h"
#include "io/stamped_rows.h"

namespace armature {
namespace {

std::string ReadCategory(const CsvRow& row, const std::vector<std::string>& categories) {
  const std::string& category = row.Text("category");
  if (std::find(categories.begin(), categories.end(), category) == categories.end()) {
    throw InputError(row.At(UnknownNameMessage("category", category, categories)));
  }
  return category;
}

Box ReadBox(const CsvRow& row, const Camera& camera) {
  const Box box{row.Number("x"), row.Number("y"), row.Number("width"), row.Number("height")};
  if (box.width <= 0 || box.height <= 0) {
    throw InputError(row.At(fmt::format(
        "the box is {} x {} pixels; width and height have to be greater than 0", box.width, box.height)));
  }
  const Box image{-0.5, -0.5, static_cast<double>(camera.width), static_cast<double>(camera.height)};
  const Box inside = Intersection(box, image);
  if (inside.width <= 0 || inside.height <= 0) {
    throw InputError(
        row.At(fmt::format("the box at ({}, {}), {} x {} pixels, is outside the {} x {} image; remove the "
                           "row or correct the box",
                           box.x, box.y, box.width, box.height, camera.width, camera.height)));
  }
  return box;
}

double ReadScore(const CsvRow& row) {
  const double score = row.Number("score");
  if (score < 0 || score > 1) {
    throw InputError(row.At(fmt::format("score {} is outside 0..1; scale it to a probability", score)));
  }
  return score;
}

// `most`: degrees either way; radians of an angle that is written in degrees, none where there is none.
std::optional<double> ReadAngle(const CsvRow& row, const std::string& column, bool has_column, double most) {
  if (!has_column || row.IsEmpty(column)) return std::nullopt;
  const double degrees = row.Number(column);
  if (std::abs(degrees) > most)
    throw InputError(
        row.At(fmt::format("{} {:g} is outside -{:g}..{:g} degrees", column, degrees, most, most)));
  return degrees * kDegree;
}

}  // namespace

std::vector<std::vector<Detection>> ReadDetections(const std::filesystem::path& file,
                                                   const std::vector<ImageEntry>& images,
                                                   const Camera& camera,
                                                   const std::vector<std::string>& categories) {
  const CsvTable table(file, {"timestamp", "category", "x", "y", "width", "height", "score"});
  table.CheckColumnsKnown({"timestamp", "category", "x", "y", "width", "height", "score", "azimuth_deg",
                           "elevation_deg", "tilt_deg"});
  const bool has_azimuth = table.HasColumn("azimuth_deg");
  const bool has_elevation = table.HasColumn("elevation_deg");
  const bool has_tilt = table.HasColumn("tilt_deg");
  const ImageStamps stamps(images);
  std::vector<std::vector<Detection>> detections(images.size());
  for (const CsvRow& row : table.rows()) {
    Detection detection;
    detection.category = ReadCategory(row, categories);
    detection.box = ReadBox(row, camera);
    detection.score = ReadScore(row);
    detection.azimuth = ReadAngle(row, "azimuth_deg", has_azimuth, 360);
    detection.elevation = ReadAngle(row, "elevation_deg", has_elevation, 90);
    detection.tilt = ReadAngle(row, "tilt_deg", has_tilt, 360);
    detections[stamps.FindImage(row)].push_back(detection);
  }
  return detections;
}

}  // namespace armature
