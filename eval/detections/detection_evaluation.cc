// SPDX-License-Identifier: BSD-3-Clause
#include "eval/detections/detection_evaluation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "base/statistics.h"
#include "category/category_lookup.h"
#include "eval/detections/lasting.h"
#include "eval/detections/matched_detections.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

constexpr double kSoon = 0.2, kLater = 1;  // seconds between errors that are compared

// A frame with everything that it is judged by.
struct JudgedFrame {
  double timestamp = 0;
  Eigen::Isometry3d T_world_camera;
  const std::vector<Detection>* detections = nullptr;
  std::vector<TrueBox> seen;
  std::vector<MatchedDetection> matched;  // as detections
};

std::vector<std::string> CategoriesOf(const std::vector<TrueObject>& objects) {
  std::vector<std::string> categories;
  for (const TrueObject& object : objects) categories.push_back(object.category);
  return categories;
}

std::vector<JudgedFrame> JudgeFrames(const std::vector<DetectedFrame>& frames, const SequenceTruth& sequence,
                                     const std::vector<CategoryModel>& models) {
  const TrueWireframes wireframes(sequence.truth.objects, models);
  const std::vector<std::string> categories = CategoriesOf(sequence.truth.objects);
  std::vector<JudgedFrame> judged;
  for (const DetectedFrame& frame : frames) {
    const std::optional<size_t> camera = FindStamp(sequence.truth.T_world_camera, frame.timestamp);
    if (!camera) continue;
    JudgedFrame one{frame.timestamp, sequence.truth.T_world_camera[*camera].pose, &frame.detections, {}, {}};
    one.seen = wireframes.Seen(sequence.camera, one.T_world_camera);
    one.matched = MatchDetections(frame.detections, one.seen, categories);
    judged.push_back(std::move(one));
  }
  return judged;
}

// What is added up over the frames, of one category or all.
struct Sums {
  long asked_for = 0, right = 0, detections = 0, duplicates = 0, wrong_category = 0, false_alarms = 0;
  long frames = 0;
  std::vector<double> ious, azimuth_errors_deg, elevation_errors_deg;
  RunLengths misses;
  BoxLengths alarms;
  std::vector<ErrorSeries> sides, azimuths;
  double squares = 0;  // of the errors of sides
  long sides_count = 0;
};

// The errors of an object's sides, as shares of its box, of those that are not at the image's border.
std::array<std::optional<double>, 4> SideErrors(const Box& found, const Box& truth, const Camera& camera) {
  constexpr double kBorder = 2;  // pixels
  std::array<std::optional<double>, 4> errors;
  if (truth.left() > kBorder) errors[0] = (found.left() - truth.left()) / truth.width;
  if (truth.right() < camera.width - 1 - kBorder) errors[1] = (found.right() - truth.right()) / truth.width;
  if (truth.top() > kBorder) errors[2] = (found.top() - truth.top()) / truth.height;
  if (truth.bottom() < camera.height - 1 - kBorder)
    errors[3] = (found.bottom() - truth.bottom()) / truth.height;
  return errors;
}

class DetectionJudge {
 public:
  DetectionJudge(const SequenceTruth& sequence, const std::vector<CategoryModel>& models,
                 const std::optional<std::string>& category)
      : sequence_(sequence), models_(models), category_(category) {}

  Sums AddUp(const std::vector<JudgedFrame>& frames) {
    for (const JudgedFrame& frame : frames) AddDetections(frame);
    for (size_t object = 0; object < sequence_.truth.objects.size(); ++object) {
      if (IsOurs(sequence_.truth.objects[object].category)) AddObject(object, frames);
    }
    return std::move(sums_);
  }

 private:
  bool IsOurs(const std::string& category) const { return !category_ || *category_ == category; }

  void AddDetections(const JudgedFrame& frame) {
    ++sums_.frames;
    std::vector<Box> alarms;
    for (size_t i = 0; i < frame.matched.size(); ++i) {
      const Detection& detection = (*frame.detections)[i];
      const MatchedDetection& match = frame.matched[i];
      if (!IsOurs(detection.category) || match.verdict == DetectionVerdict::kNotJudged) continue;
      ++sums_.detections;
      sums_.duplicates += match.verdict == DetectionVerdict::kDuplicate;
      sums_.wrong_category += match.verdict == DetectionVerdict::kWrongCategory;
      sums_.false_alarms += match.verdict == DetectionVerdict::kFalseAlarm;
      if (match.verdict == DetectionVerdict::kWrongCategory || match.verdict == DetectionVerdict::kFalseAlarm)
        alarms.push_back(detection.box);
    }
    sums_.alarms.AddFrame(alarms);
  }

  // Follows the object through all frames.
  void AddObject(size_t object, const std::vector<JudgedFrame>& frames) {
    sums_.misses.Break();
    std::array<ErrorSeries, 4> sides;
    ErrorSeries azimuths;
    for (const JudgedFrame& frame : frames) {
      const auto seen = std::find_if(frame.seen.begin(), frame.seen.end(),
                                     [&](const TrueBox& one) { return one.object == object; });
      if (seen == frame.seen.end() || !IsAskedFor(*seen)) {
        sums_.misses.Break();
        continue;
      }
      const auto place = static_cast<size_t>(seen - frame.seen.begin());
      const auto match =
          std::find_if(frame.matched.begin(), frame.matched.end(), [&](const MatchedDetection& one) {
            return one.verdict == DetectionVerdict::kRight && one.seen == place;
          });
      ++sums_.asked_for;
      sums_.misses.Add(match == frame.matched.end());
      if (match == frame.matched.end()) continue;
      ++sums_.right;
      sums_.ious.push_back(match->iou);
      const Detection& detection = (*frame.detections)[static_cast<size_t>(match - frame.matched.begin())];
      AddSides(frame.timestamp, detection.box, seen->visible, &sides);
      AddViewpoint(frame, detection, sequence_.truth.objects[object], &azimuths);
    }
    for (ErrorSeries& side : sides) sums_.sides.push_back(std::move(side));
    sums_.azimuths.push_back(std::move(azimuths));
  }

  void AddSides(double timestamp, const Box& found, const Box& truth, std::array<ErrorSeries, 4>* sides) {
    const auto errors = SideErrors(found, truth, sequence_.camera);
    for (size_t i = 0; i < errors.size(); ++i) {
      if (!errors[i]) continue;
      (*sides)[i].times.push_back(timestamp);
      (*sides)[i].errors.push_back(*errors[i]);
      sums_.squares += *errors[i] * *errors[i];
      ++sums_.sides_count;
    }
  }

  void AddViewpoint(const JudgedFrame& frame, const Detection& detection, const TrueObject& object,
                    ErrorSeries* azimuths) {
    if (!detection.azimuth) return;
    const int order = LookUpModel(models_, object.category).spec.symmetry_order;
    const Eigen::Matrix3d R_camera_object =
        frame.T_world_camera.linear().transpose() * object.T_world_object.linear();
    const Viewpoint truth =
        ViewpointFromRotation(R_camera_object, sequence_.camera.Ray(detection.box.center()));
    const double error = AzimuthDifference(*detection.azimuth, truth.azimuth, order) / kDegree;
    sums_.azimuth_errors_deg.push_back(error);
    azimuths->times.push_back(frame.timestamp);
    azimuths->errors.push_back(error);
    if (detection.elevation)
      sums_.elevation_errors_deg.push_back((*detection.elevation - truth.elevation) / kDegree);
  }

  const SequenceTruth& sequence_;
  const std::vector<CategoryModel>& models_;
  std::optional<std::string> category_;
  Sums sums_;
};

std::optional<double> ShareOf(long part, long whole) {
  if (whole == 0) return std::nullopt;
  return static_cast<double>(part) / static_cast<double>(whole);
}

std::optional<double> MedianOf(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return Median(values);
}

// Of absolute errors, those for which `is` holds.
template <typename Is>
std::optional<double> ShareWhere(const std::vector<double>& errors, const Is& is) {
  const auto count =
      std::count_if(errors.begin(), errors.end(), [&](double error) { return is(std::abs(error)); });
  return ShareOf(count, static_cast<long>(errors.size()));
}

std::vector<double> Absolute(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return values;
}

// Seconds between frames: the median.
double StepOf(const std::vector<JudgedFrame>& frames) {
  std::vector<double> steps;
  for (size_t i = 0; i + 1 < frames.size(); ++i)
    steps.push_back(frames[i + 1].timestamp - frames[i].timestamp);
  return steps.empty() ? 0 : Median(std::move(steps));
}

DetectionRecord MakeRecord(const std::string& sequence, const std::optional<std::string>& category,
                           const Sums& sums, double step) {
  return {.sequence = sequence,
          .category = category,
          .true_boxes = sums.asked_for,
          .detections = sums.detections,
          .recall_share = ShareOf(sums.right, sums.asked_for),
          .precision_share = ShareOf(sums.right, sums.detections),
          .duplicate_share = ShareOf(sums.duplicates, sums.detections),
          .wrong_category_share = ShareOf(sums.wrong_category, sums.detections),
          .false_alarms_an_image = ShareOf(sums.false_alarms, sums.frames),
          .box_iou_median = MedianOf(sums.ious),
          .views = static_cast<long>(sums.azimuth_errors_deg.size()),
          .azimuth_median_deg = MedianOf(Absolute(sums.azimuth_errors_deg)),
          .views_within_15_deg_share =
              ShareWhere(sums.azimuth_errors_deg, [](double error) { return error <= 15; }),
          .views_turned_share = ShareWhere(sums.azimuth_errors_deg, [](double error) { return error > 135; }),
          .elevation_bias_deg = MedianOf(sums.elevation_errors_deg),
          .box_error_rms_share =
              sums.sides_count > 0
                  ? std::optional(std::sqrt(sums.squares / static_cast<double>(sums.sides_count)))
                  : std::nullopt,
          .box_error_correlation_soon = CorrelationAfter(sums.sides, kSoon),
          .box_error_correlation_later = CorrelationAfter(sums.sides, kLater),
          .azimuth_error_correlation_soon = CorrelationAfter(sums.azimuths, kSoon),
          .azimuth_error_correlation_later = CorrelationAfter(sums.azimuths, kLater),
          .miss_mean_s = sums.misses.Mean(step),
          .false_alarm_mean_s = sums.alarms.Mean(step)};
}

}  // namespace

std::vector<DetectionRecord> EvaluateDetections(const std::vector<DetectedFrame>& frames,
                                                const SequenceTruth& sequence,
                                                const std::vector<CategoryModel>& models) {
  const std::vector<JudgedFrame> judged = JudgeFrames(frames, sequence, models);
  const double step = StepOf(judged);
  std::set<std::string> categories;
  for (const TrueObject& object : sequence.truth.objects) categories.insert(object.category);
  for (const DetectedFrame& frame : frames) {
    for (const Detection& detection : frame.detections) categories.insert(detection.category);
  }
  std::vector<DetectionRecord> records;
  for (const std::string& category : categories) {
    DetectionJudge judge(sequence, models, category);
    records.push_back(MakeRecord(sequence.name, category, judge.AddUp(judged), step));
  }
  DetectionJudge judge(sequence, models, std::nullopt);
  records.push_back(MakeRecord(sequence.name, std::nullopt, judge.AddUp(judged), step));
  return records;
}

}  // namespace armature
