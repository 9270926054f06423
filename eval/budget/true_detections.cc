// SPDX-License-Identifier: BSD-3-Clause
#include "eval/budget/true_detections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "base/csv_fields.h"
#include "base/errors.h"
#include "base/number_format.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"
#include "io/stamped_rows.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kDetectionColumns{"timestamp",     "category", "x",     "y",
                                                 "width",         "height",   "score", "azimuth_deg",
                                                 "elevation_deg", "tilt_deg"};
constexpr size_t kStampColumn = 0, kCategoryColumn = 1, kViewpointColumn = 7;  // and the two after it

const std::vector<std::string> kObjectColumns{"id", "category", "instance", "tx",     "ty",     "tz",    "qx",
                                              "qy", "qz",       "qw",       "size_x", "size_y", "size_z"};

struct DetectionRow {
  std::vector<std::string> fields;     // of kDetectionColumns, those that the file lacks empty
  size_t image = 0;                    // of rgb.txt
  int index = 0;                       // among the image's
  double timestamp = 0;                // seconds
  Box box;                             // pixels
  const TrueObject* object = nullptr;  // that it is of; null: of none

  bool IsRight() const { return object != nullptr && object->category == fields[kCategoryColumn]; }
};

std::vector<DetectionRow> ReadDetectionRows(const fs::path& folder, const GroundTruth& truth) {
  const CsvTable table(folder / "detections.csv",
                       {kDetectionColumns.begin(), kDetectionColumns.begin() + kViewpointColumn});
  const std::vector<ImageEntry> images = ReadImageList(folder / "rgb.txt");
  const ImageStamps stamps(images);
  std::vector<int> counts(images.size());
  std::vector<DetectionRow> rows;
  for (const CsvRow& of_file : table.rows()) {
    DetectionRow& row = rows.emplace_back();
    for (const std::string& column : kDetectionColumns)
      row.fields.push_back(table.HasColumn(column) ? of_file.Text(column) : "");
    row.image = stamps.FindImage(of_file);
    row.index = counts[row.image]++;
    row.timestamp = images[row.image].timestamp;
    row.box = {of_file.Number("x"), of_file.Number("y"), of_file.Number("width"), of_file.Number("height")};
    row.object = truth.FindObject(row.timestamp, row.index);
  }
  return rows;
}

std::string CsvLine(std::vector<std::string> fields) {
  for (std::string& field : fields) field = CsvField(field);
  return fmt::format("{}\n", fmt::join(fields, ","));
}

std::string DetectionsText(const std::vector<DetectionRow>& rows) {
  std::string text = CsvLine(kDetectionColumns);
  for (const DetectionRow& row : rows) text += CsvLine(row.fields);
  return text;
}

// The rows have objects.
std::string DetectionTruthText(const std::vector<DetectionRow>& rows) {
  std::string text = "timestamp,index,id\n";
  std::map<size_t, int> counts;  // by image
  for (const DetectionRow& row : rows)
    text += CsvLine({row.fields[kStampColumn], std::to_string(counts[row.image]++), row.object->id});
  return text;
}

std::vector<DetectionRow> OneOfEachObject(std::vector<DetectionRow> rows) {
  std::set<std::pair<size_t, const TrueObject*>> seen;
  std::vector<DetectionRow> kept;
  for (DetectionRow& row : rows) {
    if (row.IsRight() && seen.emplace(row.image, row.object).second) kept.push_back(std::move(row));
  }
  return kept;
}

// As specifications of categories have it: names become keys of YAML and names of files.
void CheckNamesCategory(const fs::path& file, const TrueObject& object) {
  const auto is_plain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
  if (std::all_of(object.id.begin(), object.id.end(), is_plain)) return;
  throw InputError(
      fmt::format("{}:{}: the id {} cannot name a category of its own; use letters, digits, '_' and '-'",
                  file.string(), object.line, Quoted(object.id)));
}

std::string ObjectsNamedById(const fs::path& file, const GroundTruth& truth) {
  for (const TrueObject& object : truth.objects) CheckNamesCategory(file, object);
  std::string text = truth.objects_source.empty() ? "" : "# " + truth.objects_source + "\n";
  text += CsvLine(kObjectColumns);
  const CsvTable table(file, kObjectColumns);
  for (const CsvRow& row : table.rows()) {
    std::vector<std::string> fields;
    for (const std::string& column : kObjectColumns)
      fields.push_back(row.Text(column == "category" ? "id" : column));
    text += CsvLine(fields);
  }
  return text;
}

void SetViewpoint(const Eigen::Isometry3d& T_camera_object, const Camera& camera, DetectionRow& row) {
  const Viewpoint viewpoint = ViewpointFromRotation(T_camera_object.linear(), camera.Ray(row.box.center()));
  size_t column = kViewpointColumn;
  for (const double angle : {viewpoint.azimuth, viewpoint.elevation, viewpoint.tilt})
    row.fields[column++] = Fixed(angle / kDegree, 4);
}

}  // namespace

SubstitutedFiles KeepTrueDetections(const fs::path& folder, const SequenceTruth& sequence) {
  const std::vector<DetectionRow> rows = OneOfEachObject(ReadDetectionRows(folder, sequence.truth));
  return {{"detections.csv", DetectionsText(rows)}, {"detections_gt.csv", DetectionTruthText(rows)}};
}

SubstitutedFiles NameDetectionsByObject(const fs::path& folder, const SequenceTruth& sequence) {
  std::vector<DetectionRow> rows = OneOfEachObject(ReadDetectionRows(folder, sequence.truth));
  for (DetectionRow& row : rows) row.fields[kCategoryColumn] = row.object->id;
  return {{"detections.csv", DetectionsText(rows)},
          {"detections_gt.csv", DetectionTruthText(rows)},
          {"objects_gt.csv", ObjectsNamedById(folder / "objects_gt.csv", sequence.truth)}};
}

SubstitutedFiles ReplaceViewpoints(const fs::path& folder, const SequenceTruth& sequence) {
  std::vector<DetectionRow> rows = ReadDetectionRows(folder, sequence.truth);
  for (DetectionRow& row : rows) {
    const auto T_camera_object = sequence.truth.TrueCameraObject(row.timestamp, row.index);
    if (row.IsRight() && T_camera_object) SetViewpoint(*T_camera_object, sequence.camera, row);
  }
  return {{"detections.csv", DetectionsText(rows)}};
}

}  // namespace armature
