// SPDX-License-Identifier: BSD-3-Clause
#include "eval/detections/detection_tables.h"

namespace armature {
namespace {

Table QualityTable(const std::vector<DetectionRecord>& records) {
  Table table;
  table.columns = {"category",      "true boxes",          "recall [%]",
                   "detections",    "precision [%]",       "duplicate [%]",
                   "wrong cat [%]", "alarms/image",        "IoU",
                   "views",         "azimuth [deg]",       "within 15 deg [%]",
                   "turned [%]",    "elevation bias [deg]"};
  for (const DetectionRecord& r : records) {
    table.rows.push_back(
        {TextCell(r.category.value_or("all")), CountCell(r.true_boxes),
         ShareCell(r.recall_share, r.true_boxes), CountCell(r.detections),
         ShareCell(r.precision_share, r.detections), ShareCell(r.duplicate_share, r.detections),
         ShareCell(r.wrong_category_share, r.detections), NumberCell(r.false_alarms_an_image, 2),
         NumberCell(r.box_iou_median, 2), CountCell(r.views), NumberCell(r.azimuth_median_deg, 1),
         ShareCell(r.views_within_15_deg_share, r.views), ShareCell(r.views_turned_share, r.views),
         NumberCell(r.elevation_bias_deg, 1)});
  }
  table.notes = {
      "true boxes: of true objects in images of which at least 30 % of the edges are seen, 24 px large: "
      "their "
      "category's mean wireframe at their true size, hidden by each other.",
      "recall: share of them that a detection of their category overlaps by half (intersection over union): "
      "what is seen of the object, or all of it in the image. IoU: median of these.",
      "precision: share of the detections that are the first of a true object. duplicate: another of the "
      "same. wrong cat: on an object of another category. alarms: on none; those of which too little is seen "
      "are not counted.",
      "azimuth: median error. turned: by more than 135 degrees. elevation bias: median of found minus true."};
  return table;
}

Table StayTable(const std::vector<DetectionRecord>& records) {
  Table table;
  table.columns = {"category",        "box error [%]", "box corr 0.2 s", "box corr 1 s",
                   "azim corr 0.2 s", "azim corr 1 s", "miss [s]",       "alarm [s]"};
  for (const DetectionRecord& r : records) {
    const auto percent = r.box_error_rms_share ? std::optional(100 * *r.box_error_rms_share) : std::nullopt;
    table.rows.push_back(
        {TextCell(r.category.value_or("all")), NumberCell(percent, 1),
         NumberCell(r.box_error_correlation_soon, 2), NumberCell(r.box_error_correlation_later, 2),
         NumberCell(r.azimuth_error_correlation_soon, 2), NumberCell(r.azimuth_error_correlation_later, 2),
         NumberCell(r.miss_mean_s, 2), NumberCell(r.false_alarm_mean_s, 2)});
  }
  table.notes = {
      "box error: root mean square over the sides that are not at the image's border, of the box's width or "
      "height. corr: correlation of the errors of an object with those so many seconds later; 0 where errors "
      "are independent from frame to frame.",
      "miss: mean time for which an object that is there is not found. alarm: mean time for which an alarm "
      "or "
      "a box of a wrong category stays where it is in the image (it overlaps that of the next frame by "
      "half)."};
  return table;
}

}  // namespace

std::vector<Table> DetectionTables(const std::vector<DetectionRecord>& records) {
  std::vector<Table> tables{QualityTable(records), StayTable(records)};
  const std::string sequence = records.front().sequence;
  tables[0].title = sequence + ": detections";
  tables[0].name = "detections";
  tables[1].title = sequence + ": how long errors of detections stay";
  tables[1].name = "detection_errors";
  for (Table& table : tables) table.sequence = sequence;
  return tables;
}

}  // namespace armature
