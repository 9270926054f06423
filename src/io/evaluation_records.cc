// SPDX-License-Identifier: BSD-3-Clause
#include "io/evaluation_records.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "io/json_fields.h"
#include "io/json_file.h"

namespace armature {
namespace {

constexpr int kRecordsSchema = 1;
constexpr const char* kRecordsRemedy = "write a new one with 'armature eval --out'";
constexpr std::array kApproaches{"odometry_only", "objects", "objects_loop_closure",
                                 "objects_no_loop_closure"};
constexpr std::array kMatchedBy{"distance", "detections"};
constexpr std::array kTrajectoryKinds{"trajectory", "odometry_scaled", "file"};

template <typename Enum, size_t n>
const char* NameAt(const std::array<const char*, n>& names, Enum value) {
  return names.at(static_cast<size_t>(value));
}

}  // namespace

// Found by nlohmann::json, and so not in the anonymous namespace.
static void to_json(nlohmann::ordered_json& json, Approach value) { json = NameAt(kApproaches, value); }
static void to_json(nlohmann::ordered_json& json, MatchedBy value) { json = NameAt(kMatchedBy, value); }
static void to_json(nlohmann::ordered_json& json, TrajectoryKind value) { json = TrajectoryKindName(value); }
static void to_json(nlohmann::ordered_json& json, AlignmentKind value) { json = AlignmentName(value); }
static void from_json(const nlohmann::ordered_json& json, Approach& value) {
  value = EnumFromName<Approach>(kApproaches, "approach", json.get<std::string>());
}
static void from_json(const nlohmann::ordered_json& json, MatchedBy& value) {
  value = EnumFromName<MatchedBy>(kMatchedBy, "matched_by", json.get<std::string>());
}
static void from_json(const nlohmann::ordered_json& json, TrajectoryKind& value) {
  value = EnumFromName<TrajectoryKind>(kTrajectoryKinds, "trajectory", json.get<std::string>());
}
static void from_json(const nlohmann::ordered_json& json, AlignmentKind& value) {
  value = AlignmentFromName(json.get<std::string>());
}

ARMATURE_JSON_FIELDS(EvaluatedRunRecord, folder, sequence, run);
ARMATURE_JSON_FIELDS(ViewRecord, sequence, run, category, only_ok, detections, estimates, ok,
                     azimuth_median_deg, views_within_15_deg_share, translation_median_percent,
                     distance_median_percent, up_axis_median_deg, matches, visible_edges,
                     match_precision_share, match_recall_share, near_match_precision_share,
                     near_match_recall_share);
ARMATURE_JSON_FIELDS(TrajectoryRecord, sequence, run, trajectory, alignment, matched_poses, poses,
                     alignment_scale, alignment_rotation_deg, alignment_translation_m, ate_rmse_m, ate_mean_m,
                     ate_median_m, ate_max_m, rpe_rmse_m, rpe_rmse_deg, rpe_pairs);
ARMATURE_JSON_FIELDS(ObjectRecord, sequence, run, approach, matched_by, alignment, category, true_objects,
                     observed, found, missed, spurious, object_error_best_m, object_error_worst_m,
                     object_error_mean_m, object_error_median_m, azimuth_mean_deg, tilt_mean_deg, size_mean_m,
                     iou_mean);
ARMATURE_JSON_FIELDS(UprightnessRecord, sequence, run, normal_term, objects, object_pitch_mean_deg,
                     object_pitch_median_deg, object_roll_mean_deg, object_roll_median_deg, views,
                     view_pitch_mean_deg, view_pitch_median_deg, view_roll_mean_deg, view_roll_median_deg);
ARMATURE_JSON_FIELDS(RetrievalRecord, sequence, run, category, queries, in_library, top_1_share, top_5_share,
                     mean_reciprocal_rank, compared, chamfer_m, best_of_five_chamfer_m,
                     by_true_shape_chamfer_m, chamfer_ratio, random_chamfer_m, mean_shape_chamfer_m, f_score,
                     f_score_by_true_shape);
ARMATURE_JSON_FIELDS(RoomStatisticRecord, run, statistic, rooms, value, low, high);
ARMATURE_JSON_FIELDS(RoomDifferenceRecord, statistic, run_a, run_b, rooms, mean_a, mean_b, difference, low,
                     high, mark, rooms_to_show_a_tenth);
ARMATURE_JSON_FIELDS(RoomErrorsRecord, run, object_errors_m, missed);
ARMATURE_JSON_FIELDS(WorstRoomRecord, run, sequence, folder, error_m);
ARMATURE_JSON_FIELDS(PaperRecord, sequence, approach, objects, object_error_best_m, object_error_worst_m,
                     object_error_mean_m);
ARMATURE_JSON_FIELDS(DetectionRecord, sequence, category, true_boxes, detections, recall_share,
                     precision_share, duplicate_share, wrong_category_share, false_alarms_an_image,
                     box_iou_median, views, azimuth_median_deg, views_within_15_deg_share, views_turned_share,
                     elevation_bias_deg, box_error_rms_share, box_error_correlation_soon,
                     box_error_correlation_later, azimuth_error_correlation_soon,
                     azimuth_error_correlation_later, miss_mean_s, false_alarm_mean_s);

namespace {

// Calls visit(key, list) for each list of the records.
template <typename Records, typename Visit>
void VisitLists(Records& records, const Visit& visit) {
  visit("runs", records.runs);
  visit("views", records.views);
  visit("trajectories", records.trajectories);
  visit("objects", records.objects);
  visit("uprightness", records.uprightness);
  visit("retrieval", records.retrieval);
  visit("paper", records.paper);
}

// Lists that a file need not have: those of evaluations over rooms and of detections.
template <typename Records, typename Visit>
void VisitOptionalLists(Records& records, const Visit& visit) {
  visit("rooms", records.rooms);
  visit("room_differences", records.room_differences);
  visit("room_errors", records.room_errors);
  visit("worst_rooms", records.worst_rooms);
  visit("detections", records.detections);
}

InputError BadRecords(const std::filesystem::path& file, const std::string& why) {
  return InputError(fmt::format("{}: {}; {}", file.string(), why, kRecordsRemedy));
}

template <typename Record>
void ReadList(const nlohmann::ordered_json& json, const char* key, std::vector<Record>& records) {
  const auto list = json.find(key);
  if (list == json.end() || !list->is_array()) throw InputError(fmt::format("there is no list '{}'", key));
  for (const auto& entry : *list) {
    try {
      records.push_back(JsonAs<Record>(entry, "it"));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}[{}]: {}", key, records.size(), error.what()));
    }
  }
}

}  // namespace

const std::vector<std::string>& AlignmentNames() {
  static const std::vector<std::string> kNames = {"none",  "first_pose", "se3",    "sim3",
                                                  "scale", "end_points", "first_n"};
  return kNames;
}

std::string AlignmentName(AlignmentKind kind) { return AlignmentNames()[static_cast<size_t>(kind)]; }

AlignmentKind AlignmentFromName(const std::string& name) {
  const auto found = std::find(AlignmentNames().begin(), AlignmentNames().end(), name);
  if (found == AlignmentNames().end())
    throw InputError(UnknownNameMessage("alignment", name, AlignmentNames()));
  return static_cast<AlignmentKind>(found - AlignmentNames().begin());
}

std::string TrajectoryKindName(TrajectoryKind kind) { return NameAt(kTrajectoryKinds, kind); }

void AppendRecords(EvaluationRecords more, EvaluationRecords& records) {
  const auto append = [](auto& from, auto& to) {
    std::move(from.begin(), from.end(), std::back_inserter(to));
  };
  append(more.runs, records.runs);
  append(more.views, records.views);
  append(more.trajectories, records.trajectories);
  append(more.objects, records.objects);
  append(more.uprightness, records.uprightness);
  append(more.retrieval, records.retrieval);
  append(more.paper, records.paper);
  append(more.detections, records.detections);
  append(more.rooms, records.rooms);
  append(more.room_differences, records.room_differences);
  append(more.room_errors, records.room_errors);
  append(more.worst_rooms, records.worst_rooms);
}

std::string EvaluationRecordsJson(const EvaluationRecords& records) {
  nlohmann::ordered_json json{{"schema", kRecordsSchema}};
  VisitLists(records, [&](const char* key, const auto& list) { json[key] = list; });
  VisitOptionalLists(records, [&](const char* key, const auto& list) {
    if (!list.empty()) json[key] = list;
  });
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

EvaluationRecords ReadEvaluationRecords(const std::filesystem::path& file) {
  const auto json = ReadJson(file, kRecordsRemedy);
  if (!json.is_object() || !json.contains("schema"))
    throw BadRecords(file, "is no file of records, it has no 'schema'");
  if (json["schema"] != kRecordsSchema)
    throw BadRecords(file, fmt::format("has schema {}, not {}", json["schema"].dump(), kRecordsSchema));
  EvaluationRecords records;
  try {
    VisitLists(records, [&](const char* key, auto& list) { ReadList(json, key, list); });
    VisitOptionalLists(records, [&](const char* key, auto& list) {
      if (json.contains(key)) ReadList(json, key, list);
    });
  } catch (const InputError& error) {
    throw BadRecords(file, error.what());
  }
  return records;
}

}  // namespace armature
