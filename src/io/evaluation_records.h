// SPDX-License-Identifier: BSD-3-Clause
// records.json of a folder of `armature eval --out`: every number that other tools take from an evaluation,
// under the names of the members below. Tables are for readers; no program looks for a number in them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace armature {

// What brings an estimate to the truth (in brackets: evo's options for the same).
enum class AlignmentKind {
  kNone,       // nothing: the frames have to agree
  kFirstPose,  // the rigid motion that puts the first estimated pose on the true one (--align_origin)
  kSe3,        // the rigid motion of least squared distances of the positions (-a)
  kSim3,       // the similarity of least squared distances of the positions (-a -s)
  kScale,      // sim3's scale, then the first pose on the true one (-s --align_origin)
  kEndPoints,  // scale: the true distance from the first to the last position over the estimated one, as the
               // paper does; then the first pose on the true one
  kFirstN      // se3 of the first N pairs alone (-a --n_to_align N)
};

// none, first_pose, se3, sim3, scale, end_points, first_n; in the order of the enumeration.
const std::vector<std::string>& AlignmentNames();
std::string AlignmentName(AlignmentKind kind);
AlignmentKind AlignmentFromName(const std::string& name);  // throws InputError for another name

// How the objects of a map were placed: odometry_only, objects, objects_loop_closure,
// objects_no_loop_closure.
enum class Approach {
  kOdometryOnly,         // by the odometry alone
  kObjects,              // in the graph; the run does not say whether it closed loops
  kObjectsLoopClosure,   // in the graph with loop closure
  kObjectsNoLoopClosure  // in the graph without
};

// What decides which true object one of the map is: distance (one-to-one, the nearest), detections (that of
// most of its observations).
enum class MatchedBy { kDistance, kDetections };

// trajectory: of the map's graph; odometry_scaled: the odometry in metres; file: one given by itself.
enum class TrajectoryKind { kTrajectory, kOdometryScaled, kFile };
std::string TrajectoryKindName(TrajectoryKind kind);

// Names of sequences and runs are those of the tables. No value: it cannot be known, as the error of objects
// of which none was found; null in the file. Shares are 0..1.

struct EvaluatedRunRecord {
  std::string folder{};  // as it was given, or found in the folder that was
  std::string sequence{}, run{};
};

// Single views of true objects.
struct ViewRecord {
  std::string sequence{}, run{};
  std::optional<std::string> category{};  // none: all
  bool only_ok = false;                   // estimates are those with status ok, and shares are of them
  long detections = 0, estimates = 0, ok = 0;
  std::optional<double> azimuth_median_deg{}, views_within_15_deg_share{};
  std::optional<double> translation_median_percent{}, distance_median_percent{}, up_axis_median_deg{};
  // Of edges and segments; near: with 5 cm more between them.
  long matches = 0, visible_edges = 0;
  std::optional<double> match_precision_share{}, match_recall_share{};
  std::optional<double> near_match_precision_share{}, near_match_recall_share{};
};

// One trajectory under one alignment. Without matched poses there are no errors.
struct TrajectoryRecord {
  std::string sequence{}, run{};
  TrajectoryKind trajectory = TrajectoryKind::kTrajectory;
  AlignmentKind alignment = AlignmentKind::kNone;
  long matched_poses = 0, poses = 0;
  std::optional<double> alignment_scale{}, alignment_rotation_deg{}, alignment_translation_m{};
  std::optional<double> ate_rmse_m{}, ate_mean_m{}, ate_median_m{}, ate_max_m{};
  std::optional<double> rpe_rmse_m{}, rpe_rmse_deg{};
  long rpe_pairs = 0;
};

// The objects of one map. Errors are of the found ones, absolute; `object_error` is of the centres.
struct ObjectRecord {
  std::string sequence{}, run{};
  Approach approach = Approach::kObjects;
  MatchedBy matched_by = MatchedBy::kDistance;
  AlignmentKind alignment = AlignmentKind::kFirstPose;
  std::optional<std::string> category{};  // none: all
  long true_objects = 0, observed = 0, found = 0, missed = 0, spurious = 0;
  std::optional<double> object_error_best_m{}, object_error_worst_m{}, object_error_mean_m{},
      object_error_median_m{};
  std::optional<double> azimuth_mean_deg{}, tilt_mean_deg{}, size_mean_m{}, iou_mean{};
};

// Absolute pitch and roll of a run's found objects, and of its single views with status ok.
struct UprightnessRecord {
  std::string sequence{}, run{};
  std::optional<std::string> normal_term{};  // as the run's config.yaml has it
  long objects = 0;
  std::optional<double> object_pitch_mean_deg{}, object_pitch_median_deg{};
  std::optional<double> object_roll_mean_deg{}, object_roll_median_deg{};
  long views = 0;
  std::optional<double> view_pitch_mean_deg{}, view_pitch_median_deg{}, view_roll_mean_deg{},
      view_roll_median_deg{};
};

// The default way of retrieval.
struct RetrievalRecord {
  std::optional<std::string> sequence{};  // none: all of the run's, where they are several
  std::string run{};
  std::optional<std::string> category{};  // none: all, where they are several
  long queries = 0, in_library = 0;
  std::optional<double> top_1_share{}, top_5_share{}, mean_reciprocal_rank{};
  long compared = 0;
  // Chamfer distances: of what was found, of the best of five, of what the true shape finds, ...
  std::optional<double> chamfer_m{}, best_of_five_chamfer_m{}, by_true_shape_chamfer_m{}, chamfer_ratio{};
  std::optional<double> random_chamfer_m{}, mean_shape_chamfer_m{};
  std::optional<double> f_score{}, f_score_by_true_shape{};
};

// A number over the rooms of a run's name, and between what it lies in 95 of 100 draws of the rooms.
struct RoomStatisticRecord {
  std::string run{}, statistic{};  // "object_error_median_m"
  long rooms = 0;
  std::optional<double> value{}, low{}, high{};
};

// The mean over rooms of b's number of a room less a's.
struct RoomDifferenceRecord {
  std::string statistic{}, run_a{}, run_b{};
  long rooms = 0;
  double mean_a = 0, mean_b = 0, difference = 0, low = 0, high = 0;
  std::string mark{};                           // same, lower, higher, too few
  std::optional<long> rooms_to_show_a_tenth{};  // a difference of a tenth of a's mean; none: not known
};

// The centres' errors of all objects found in any room, and how many were missed.
struct RoomErrorsRecord {
  std::string run{};
  std::vector<double> object_errors_m{};
  long missed = 0;
};

// Worst first.
struct WorstRoomRecord {
  std::string run{}, sequence{}, folder{};
  double error_m = 0;  // a missed or spurious object counts as far off as the gate
};

// A row of the paper's own table.
struct PaperRecord {
  std::string sequence{}, approach{};  // "1", "Ours"
  long objects = 0;
  double object_error_best_m = 0, object_error_worst_m = 0, object_error_mean_m = 0;
};

// Detections of a sequence against its true objects, without any run.
struct DetectionRecord {
  std::string sequence{};
  std::optional<std::string> category{};  // none: all
  long true_boxes = 0, detections = 0;
  std::optional<double> recall_share{}, precision_share{}, duplicate_share{}, wrong_category_share{};
  std::optional<double> false_alarms_an_image{}, box_iou_median{};
  long views = 0;  // detections of a true object with a viewpoint
  std::optional<double> azimuth_median_deg{}, views_within_15_deg_share{}, views_turned_share{},
      elevation_bias_deg{};
  // How long errors stay: correlations after 0.2 and 1 second, mean lengths in seconds.
  std::optional<double> box_error_rms_share{}, box_error_correlation_soon{}, box_error_correlation_later{};
  std::optional<double> azimuth_error_correlation_soon{}, azimuth_error_correlation_later{};
  std::optional<double> miss_mean_s{}, false_alarm_mean_s{};
};

// Lists of what was not asked for, or has no truth, are empty; the file has that of detections only where it
// was asked for.
struct EvaluationRecords {
  std::vector<EvaluatedRunRecord> runs{};
  std::vector<ViewRecord> views{};
  std::vector<TrajectoryRecord> trajectories{};
  std::vector<ObjectRecord> objects{};
  std::vector<UprightnessRecord> uprightness{};
  std::vector<RetrievalRecord> retrieval{};
  std::vector<PaperRecord> paper{};
  std::vector<DetectionRecord> detections{};
  // Only in files of evaluations over rooms.
  std::vector<RoomStatisticRecord> rooms{};
  std::vector<RoomDifferenceRecord> room_differences{};
  std::vector<RoomErrorsRecord> room_errors{};
  std::vector<WorstRoomRecord> worst_rooms{};
};

// At the ends of the lists.
void AppendRecords(EvaluationRecords more, EvaluationRecords& records);

// {"schema": 1, "runs": [{...}], "views": [...], ...}, ends with a line break.
std::string EvaluationRecordsJson(const EvaluationRecords& records);

// Throws InputError, which names the file and the key: it cannot be read, is not JSON, has another schema, a
// record lacks a key, has a value of another kind or a name that is not of its enumeration.
EvaluationRecords ReadEvaluationRecords(const std::filesystem::path& file);

}  // namespace armature
