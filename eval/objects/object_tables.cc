// SPDX-License-Identifier: BSD-3-Clause
#include "eval/objects/object_tables.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "base/csv_fields.h"
#include "base/number_format.h"

namespace armature {
namespace {

std::vector<Cell> SummaryRow(const ObjectRecord& r) {
  std::vector<Cell> row{TextCell(r.run), TextCell(ApproachTitle(r.approach)),
                        TextCell(r.category.value_or("all"))};
  for (const long count : {r.true_objects, r.observed, r.found, r.missed, r.spurious})
    row.push_back(CountCell(count));
  for (const auto& metres :
       {r.object_error_best_m, r.object_error_worst_m, r.object_error_mean_m, r.object_error_median_m})
    row.push_back(NumberCell(metres, 4));
  row.push_back(NumberCell(r.azimuth_mean_deg, 2));
  row.push_back(NumberCell(r.tilt_mean_deg, 2));
  row.push_back(NumberCell(r.size_mean_m, 4));
  row.push_back(NumberCell(r.iou_mean, 3));
  return row;
}

// Of true and of spurious objects.
std::vector<std::string> ListCategories(const SequenceObjects& sequence) {
  std::set<std::string> categories;
  for (const NamedObjects& run : sequence.runs) {
    for (const EvaluatedMap& map : run.objects.maps) {
      for (const EvaluatedObject& object : map.by_distance) categories.insert(object.category);
    }
  }
  return {categories.begin(), categories.end()};
}

std::vector<std::string> SummaryDefinitions(double gate_m) {
  return {
      "true: objects of the ground truth. observed: those of them that some detection is of, or that were "
      "found.",
      fmt::format(
          "found: matched one-to-one within its category by the centres' distance, at most {} m; as many as "
          "possible, of those the least sum. missed: observed and not found.",
          gate_m),
      "spurious: objects of the map that are matched to no true one, second ones of the same too.",
      "best, worst, average, median: distance of the centres of the boxes, of the found ones alone.",
      "azimuth, tilt, size, IoU: averages over the found ones. azimuth: heading about the true up axis, the "
      "true object's y; symmetric turns are equal. tilt: angle between the y axes. size: mean absolute "
      "error over the axes, under the nearest symmetric turn. IoU: common over joint volume of the boxes."};
}

std::vector<Cell> ObjectRow(const std::string& run, const EvaluatedMap& map, const EvaluatedObject& object) {
  const auto text = [](const std::string& id) { return id.empty() ? NoCell() : TextCell(id); };
  std::vector<Cell> row{TextCell(run),
                        TextCell(ApproachTitle(map.approach)),
                        text(object.true_id),
                        TextCell(object.category),
                        TextCell(StatusName(object.status)),
                        text(object.map_id)};
  const auto push = [&](auto value, int digits) {
    row.push_back(object.error ? NumberCell(value(*object.error), digits) : NoCell());
  };
  push([](const ObjectError& e) { return e.centre_m; }, 4);
  push([](const ObjectError& e) { return std::abs(e.orientation.azimuth_deg); }, 2);
  push([](const ObjectError& e) { return e.orientation.tilt_deg; }, 2);
  push([](const ObjectError& e) { return e.mean_size_m(); }, 4);
  push([](const ObjectError& e) { return e.iou; }, 3);
  row.push_back(object.map_id.empty() ? NoCell() : CountCell(object.observations));
  return row;
}

std::string ErrorFields(const ObjectError& e) {
  return fmt::format("{},{},{},{},{},{},{},{},{}", Fixed(e.centre_m, 6), Fixed(e.orientation.azimuth_deg, 4),
                     Fixed(e.orientation.pitch_deg, 4), Fixed(e.orientation.roll_deg, 4),
                     Fixed(e.orientation.tilt_deg, 4), Fixed(e.size_m.x(), 6), Fixed(e.size_m.y(), 6),
                     Fixed(e.size_m.z(), 6), Fixed(e.iou, 6));
}

// The columns that all objects of a map have in common.
std::string RawStart(const SequenceObjects& sequence, const NamedObjects& run, const EvaluatedMap& map) {
  const RunConfiguration& c = run.objects.configuration;
  const std::string loop_closure = c.loop_closure ? fmt::format("{}", *c.loop_closure) : "";
  return fmt::format("{},{},{},{},{},{},{}", CsvField(run.run), CsvField(sequence.sequence),
                     CsvField(c.normal_term.value_or("")), loop_closure,
                     map.is_by_odometry() ? "odometry" : "objects", AlignmentName(sequence.options.alignment),
                     Fixed(map.T_truth_run.scale, 9));
}

std::string RawRows(const std::string& start, const std::string& matching,
                    const std::vector<EvaluatedObject>& objects) {
  std::string text;
  for (const EvaluatedObject& o : objects) {
    text += fmt::format("{},{},{},{},{},{},{},{}\n", start, matching, StatusName(o.status),
                        CsvField(o.true_id), CsvField(o.category), CsvField(o.map_id),
                        o.map_id.empty() ? "" : fmt::format("{}", o.observations),
                        o.error ? ErrorFields(*o.error) : ",,,,,,,,");
  }
  return text;
}

}  // namespace

std::vector<std::string> ObjectNotes(const SequenceObjects& sequence) {
  std::vector<std::string> notes;
  std::string how = AlignmentName(sequence.options.alignment);
  if (sequence.options.alignment == AlignmentKind::kFirstN)
    how += fmt::format(" ({})", sequence.options.first_n);
  notes.push_back(fmt::format(
      "Each map is moved to the truth as its cameras are: alignment {}, scale 1 unless told below.", how));
  for (const NamedObjects& run : sequence.runs) {
    if (run.objects.maps.empty())
      notes.push_back(fmt::format("{}: left out, the run folder has no objects.csv.", run.run));
    for (const EvaluatedMap& map : run.objects.maps) {
      const std::string scale = Fixed(map.T_truth_run.scale, 6);
      if (scale != Fixed(1, 6))
        notes.push_back(fmt::format("{}, {}: scale {}.", run.run, ApproachTitle(map.approach), scale));
      if (map.T_truth_run.is_degenerate)
        notes.push_back(fmt::format("{}, {}: the cameras do not determine the alignment.", run.run,
                                    ApproachTitle(map.approach)));
    }
  }
  if (!sequence.truth_source.empty()) notes.push_back(fmt::format("True objects: {}", sequence.truth_source));
  return notes;
}

ObjectRecord MakeObjectRecord(const SequenceObjects& sequence, const NamedObjects& run,
                              const EvaluatedMap& map, MatchedBy matched_by,
                              const std::optional<std::string>& category) {
  const bool by_distance = matched_by == MatchedBy::kDistance;
  const ObjectSummary s = Summarise(by_distance ? map.by_distance : map.by_detections, category.value_or(""));
  const auto known = [&](double value) { return s.found > 0 ? std::optional(value) : std::nullopt; };
  return {.sequence = sequence.sequence,
          .run = run.run,
          .approach = map.approach,
          .matched_by = matched_by,
          .alignment = sequence.options.alignment,
          .category = category,
          .true_objects = s.objects,
          .observed = s.observed,
          .found = s.found,
          .missed = s.missed,
          .spurious = s.spurious,
          .object_error_best_m = known(s.best_m),
          .object_error_worst_m = known(s.worst_m),
          .object_error_mean_m = known(s.average_m),
          .object_error_median_m = known(s.median_m),
          .azimuth_mean_deg = known(s.average_azimuth_deg),
          .tilt_mean_deg = known(s.average_tilt_deg),
          .size_mean_m = known(s.average_size_m),
          .iou_mean = known(s.average_iou)};
}

std::vector<ObjectRecord> MakeObjectRecords(const SequenceObjects& sequence) {
  std::vector<std::optional<std::string>> categories;
  for (const std::string& category : ListCategories(sequence)) categories.emplace_back(category);
  categories.emplace_back();  // all
  std::vector<ObjectRecord> records;
  for (const NamedObjects& run : sequence.runs) {
    for (const EvaluatedMap& map : run.objects.maps) {
      for (const MatchedBy matched_by : {MatchedBy::kDistance, MatchedBy::kDetections}) {
        if (matched_by == MatchedBy::kDetections && map.by_detections.empty()) continue;
        for (const auto& category : categories)
          records.push_back(MakeObjectRecord(sequence, run, map, matched_by, category));
      }
    }
  }
  return records;
}

Table ObjectSummaryTable(const SequenceObjects& sequence) {
  Table table;
  table.title = sequence.sequence + ": objects of the map";
  table.name = "objects";
  table.sequence = sequence.sequence;
  table.columns = {"run",           "approach",   "category", "true",      "observed",    "found",
                   "missed",        "spurious",   "best [m]", "worst [m]", "average [m]", "median [m]",
                   "azimuth [deg]", "tilt [deg]", "size [m]", "IoU"};
  for (const ObjectRecord& record : MakeObjectRecords(sequence)) {
    if (record.matched_by == MatchedBy::kDistance) table.rows.push_back(SummaryRow(record));
  }
  table.notes = SummaryDefinitions(sequence.options.gate_m);
  for (std::string& note : ObjectNotes(sequence)) table.notes.push_back(std::move(note));
  return table;
}

Table EachObjectTable(const SequenceObjects& sequence) {
  Table table;
  table.title = sequence.sequence + ": each object";
  table.name = "each_object";
  table.sequence = sequence.sequence;
  table.columns = {"run",        "approach",      "id",         "category", "status", "map object",
                   "centre [m]", "azimuth [deg]", "tilt [deg]", "size [m]", "IoU",    "observations"};
  for (const NamedObjects& run : sequence.runs) {
    for (const EvaluatedMap& map : run.objects.maps) {
      for (const EvaluatedObject& object : map.by_distance)
        table.rows.push_back(ObjectRow(run.run, map, object));
    }
  }
  table.notes = {
      "Matched and measured as in the table of all objects. never observed: no detection is of it.",
      "id: in objects_gt.csv; map object: in objects.csv; observations: that one is made from."};
  for (std::string& note : ObjectNotes(sequence)) table.notes.push_back(std::move(note));
  return table;
}

std::string RawObjectsCsv(const std::vector<SequenceObjects>& sequences) {
  std::string text =
      "run,sequence,normal_term,loop_closure,map,alignment,scale,matching,status,id,category,map_object,"
      "observations,centre_m,azimuth_deg,pitch_deg,roll_deg,tilt_deg,size_x_m,size_y_m,size_z_m,iou\n";
  for (const SequenceObjects& sequence : sequences) {
    for (const NamedObjects& run : sequence.runs) {
      for (const EvaluatedMap& map : run.objects.maps) {
        const std::string start = RawStart(sequence, run, map);
        text += RawRows(start, "distance", map.by_distance) + RawRows(start, "detections", map.by_detections);
      }
    }
  }
  return text;
}

}  // namespace armature
