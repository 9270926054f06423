// SPDX-License-Identifier: BSD-3-Clause
// Detections against true objects: where these are in the image, what detections are, how long errors stay.
#include <gtest/gtest.h>

#include <cmath>

#include "eval/detections/detection_evaluation.h"
#include "eval/detections/lasting.h"
#include "eval/detections/matched_detections.h"
#include "support/true_world.h"

namespace armature {
namespace {

using testing::SeenFrom;

const Camera kEye{640, 480, 500, 500, 319.5, 239.5};

TrueObject TableAt(const std::string& id, const Eigen::Vector3d& place, const Eigen::Vector3d& size) {
  return {id, "table", "", SeenFrom(0, 0, place), size, 1};
}

const std::vector<CategoryModel>& Models() {
  static const std::vector<CategoryModel> kModels = LoadCategories(testing::CategoryFolder());
  return kModels;
}

TEST(TrueWireframes, HaveTheObjectsSizeInTheImage) {
  const TrueWireframes wireframes({TableAt("a", {0, 0, 3}, {1.2, 0.7, 0.6})}, Models());
  const std::vector<TrueBox> seen = wireframes.Seen(kEye, Eigen::Isometry3d::Identity());
  ASSERT_EQ(seen.size(), 1U);
  // The nearest corners are at 2.7 m; the top's reach 0.6 m to the sides, 0.35 m up and the feet as far down.
  EXPECT_NEAR(seen[0].visible.width, 500 * 1.2 / 2.7, 3);
  EXPECT_NEAR(seen[0].visible.top(), 239.5 - 500 * 0.35 / 2.7, 3);
  EXPECT_NEAR(seen[0].share, 1, 0.02);
}

TEST(TrueWireframes, AreHiddenByEachOtherAndCutByTheImage) {
  const TrueObject behind = TableAt("behind", {0, 0, 4}, {1.2, 0.7, 0.6});
  const auto alone = TrueWireframes({behind}, Models()).Seen(kEye, Eigen::Isometry3d::Identity());
  // The screen of a huge laptop before its right half.
  const TrueObject before{"before", "laptop", "", SeenFrom(0, 0, {0.5, 0, 2}), {0.8, 0.8, 0.1}, 2};
  const auto hidden = TrueWireframes({behind, before}, Models()).Seen(kEye, Eigen::Isometry3d::Identity());
  ASSERT_EQ(hidden.size(), 2U);
  EXPECT_LT(hidden[0].share, 0.8 * alone[0].share);
  EXPECT_LT(hidden[0].visible.width, 0.8 * alone[0].visible.width);
  EXPECT_NEAR(hidden[0].whole.width, alone[0].whole.width, 1e-9);
  Camera cut = kEye;
  cut.cx = 0;  // the left half is outside
  const auto half = TrueWireframes({behind}, Models()).Seen(cut, Eigen::Isometry3d::Identity());
  EXPECT_NEAR(half[0].share, 0.5, 0.1);
  EXPECT_GE(half[0].visible.left(), -0.5);
}

TrueBox SeenAt(size_t object, double x, double share = 1) {
  return {object, {x, 100, 100, 100}, {x, 100, 100, 100}, share};
}

Detection DetectedAt(const std::string& category, double x, double score) {
  Detection detection;
  detection.category = category;
  detection.box = {x, 100, 100, 100};
  detection.score = score;
  return detection;
}

TEST(MatchDetections, TellsWhatEachDetectionIs) {
  const std::vector<TrueBox> seen = {SeenAt(0, 0), SeenAt(1, 200), SeenAt(2, 400, 0.1)};
  const auto matched = MatchDetections({DetectedAt("chair", 20, 0.5),    // a worse one of the first
                                        DetectedAt("chair", 5, 0.9),     // the first
                                        DetectedAt("chair", 205, 0.8),   // on the table
                                        DetectedAt("chair", 395, 0.7),   // on what is hardly seen
                                        DetectedAt("chair", 300, 0.6)},  // on nothing by half
                                       seen, {"chair", "table", "chair"});
  EXPECT_EQ(matched[0].verdict, DetectionVerdict::kDuplicate);
  EXPECT_EQ(matched[1].verdict, DetectionVerdict::kRight);
  EXPECT_NEAR(matched[1].iou, 95.0 / 105, 1e-9);
  EXPECT_EQ(matched[2].verdict, DetectionVerdict::kWrongCategory);
  EXPECT_EQ(matched[3].verdict, DetectionVerdict::kNotJudged);
  EXPECT_EQ(matched[4].verdict, DetectionVerdict::kFalseAlarm);
}

TEST(MatchDetections, AcceptsTheBoxOfWhatIsSeenAndOfTheWholeObject) {
  TrueBox half = SeenAt(0, 0);
  half.visible.width = 40;
  Detection narrow = DetectedAt("chair", 0, 0.5);
  narrow.box.width = 40;
  for (const Detection& detection : {DetectedAt("chair", 0, 0.5), narrow})
    EXPECT_EQ(MatchDetections({detection}, {half}, {"chair"})[0].verdict, DetectionVerdict::kRight);
}

ErrorSeries Series(const std::vector<double>& errors) {
  ErrorSeries series;
  for (size_t i = 0; i < errors.size(); ++i) {
    series.times.push_back(0.2 * static_cast<double>(i));
    series.errors.push_back(errors[i]);
  }
  return series;
}

TEST(Lasting, CorrelationIsOfTheSameSeriesAfterTheLag) {
  std::vector<double> alternating, constant(20, 3);
  for (int i = 0; i < 20; ++i) alternating.push_back(i % 2 ? 1 : -1);
  EXPECT_NEAR(CorrelationAfter({Series(alternating)}, 0.2).value(), -1, 1e-9);
  EXPECT_NEAR(CorrelationAfter({Series(alternating)}, 0.4).value(), 1, 1e-9);
  // Two objects that are always wrong, each in its way.
  EXPECT_NEAR(CorrelationAfter({Series(constant), Series(std::vector<double>(20, -3))}, 1).value(), 1, 1e-9);
  EXPECT_FALSE(CorrelationAfter({Series({1, -1, 1})}, 0.2));
}

TEST(Lasting, RunsEndWhereTheyBreak) {
  RunLengths runs;
  EXPECT_FALSE(runs.Mean(0.2));
  for (const bool on : {true, true, false, true}) runs.Add(on);
  runs.Break();
  runs.Add(true);
  EXPECT_NEAR(runs.Mean(0.2).value(), 0.2 * 4 / 3, 1e-12);
}

TEST(Lasting, BoxesGoOnWhereTheyOverlap) {
  BoxLengths lengths;
  lengths.AddFrame({{0, 0, 10, 10}});
  lengths.AddFrame({{1, 0, 10, 10}, {50, 0, 10, 10}});
  lengths.AddFrame({{2, 0, 10, 10}});
  EXPECT_NEAR(lengths.Mean(0.5).value(), 0.5 * 4 / 2, 1e-12);
}

// The chair and the table of a still camera, a frame each 0.2 s.
SequenceTruth StillTruth(int frames) {
  SequenceTruth sequence{"still", kEye, {}, {}};
  for (int i = 0; i < frames; ++i)
    sequence.truth.T_world_camera.push_back({.timestamp = 0.2 * i, .pose = Eigen::Isometry3d::Identity()});
  sequence.truth.objects = {{"c", "chair", "", SeenFrom(30, 20, {-0.7, 0, 3}), {0.45, 0.9, 0.5}, 1},
                            {"t", "table", "", SeenFrom(-20, 20, {0.7, 0, 3}), {1.2, 0.74, 0.6}, 2}};
  return sequence;
}

TEST(EvaluateDetections, HasTheNumbersOfWhatWasPutIn) {
  const SequenceTruth truth = StillTruth(20);
  const Box box =
      TrueWireframes(truth.truth.objects, Models()).Seen(kEye, Eigen::Isometry3d::Identity()).at(0).visible;
  std::vector<DetectedFrame> frames;
  for (int i = 0; i < 20; ++i) {
    frames.push_back({0.2 * i, {}});
    if (i >= 5 && i < 10) continue;  // missed for a second
    Detection chair;
    chair.category = "chair";
    chair.box = {box.x + 0.1 * box.width, box.y, box.width, box.height};
    chair.score = 0.9;
    const Viewpoint seen =
        ViewpointFromRotation(truth.truth.objects[0].T_world_object.linear(), kEye.Ray(chair.box.center()));
    chair.azimuth = seen.azimuth + (i % 4 == 0 ? 30 : 10) * kDegree;
    chair.elevation = seen.elevation - 6 * kDegree;
    chair.tilt = seen.tilt;
    frames.back().detections.push_back(chair);
    if (i == 0) frames.back().detections.push_back(DetectedAt("chair", 10, 0.4));
  }
  const std::vector<DetectionRecord> records = EvaluateDetections(frames, truth, Models());
  ASSERT_EQ(records.size(), 3U);
  const DetectionRecord& chair = records[0];
  EXPECT_EQ(chair.category, "chair");
  EXPECT_EQ(chair.true_boxes, 20);
  EXPECT_NEAR(chair.recall_share.value(), 0.75, 1e-9);
  EXPECT_NEAR(chair.precision_share.value(), 15.0 / 16, 1e-9);
  EXPECT_NEAR(chair.false_alarms_an_image.value(), 1.0 / 20, 1e-9);
  EXPECT_NEAR(chair.box_iou_median.value(), 0.9 / 1.1, 1e-6);
  EXPECT_NEAR(chair.box_error_rms_share.value(), std::sqrt(0.5) * 0.1, 1e-6);
  EXPECT_EQ(chair.views, 15);
  EXPECT_NEAR(chair.azimuth_median_deg.value(), 10, 1e-6);
  EXPECT_NEAR(chair.views_within_15_deg_share.value(), 11.0 / 15, 1e-9);
  EXPECT_EQ(chair.views_turned_share.value(), 0);
  EXPECT_NEAR(chair.elevation_bias_deg.value(), -6, 1e-6);
  EXPECT_NEAR(chair.miss_mean_s.value(), 1, 1e-9);
  EXPECT_NEAR(chair.box_error_correlation_soon.value(), 1, 1e-6);
  const DetectionRecord& table = records[1];
  EXPECT_EQ(table.detections, 0);
  EXPECT_EQ(table.recall_share, 0);
  EXPECT_FALSE(table.precision_share);
  EXPECT_FALSE(records[2].category);
  EXPECT_NEAR(records[2].recall_share.value(), 15.0 / 40, 1e-9);
}

}  // namespace
}  // namespace armature
