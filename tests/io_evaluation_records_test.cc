// SPDX-License-Identifier: BSD-3-Clause
// records.json: what is written comes back, and what is wrong with it is told.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/evaluation_records.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

EvaluationRecords OneOfEach() {
  EvaluationRecords records;
  records.runs = {{"runs/a/den", "den", "a"}};
  records.views = {
      {.sequence = "den", .run = "a", .category = "chair", .views_within_15_deg_share = 1.0 / 3}};
  records.trajectories = {{.sequence = "den",
                           .run = "a",
                           .trajectory = TrajectoryKind::kOdometryScaled,
                           .alignment = AlignmentKind::kEndPoints,
                           .ate_rmse_m = 0.1}};
  records.objects = {{.sequence = "den",
                      .run = "a",
                      .approach = Approach::kObjectsNoLoopClosure,
                      .matched_by = MatchedBy::kDetections,
                      .found = 3,
                      .object_error_mean_m = 0.0625}};
  records.uprightness = {{.sequence = "den", .run = "a", .object_roll_mean_deg = 2}};
  records.retrieval = {{.run = "a", .category = "chair", .queries = 4, .chamfer_m = 0.01}};
  records.paper = {{"1", "Ours", 7, 0.1, 0.9, 0.5}};
  return records;
}

EvaluationRecords WithDetectionsAndRooms() {
  EvaluationRecords records = OneOfEach();
  records.detections = {{.sequence = "den", .category = "table", .true_boxes = 7, .recall_share = 0.25}};
  records.rooms = {{.run = "a", .statistic = "found_share", .rooms = 40, .value = 0.5, .low = 0.4}};
  records.room_differences = {{.statistic = "scale_error_share",
                               .run_a = "a",
                               .run_b = "b",
                               .rooms = 40,
                               .difference = -0.125,
                               .mark = "lower",
                               .rooms_to_show_a_tenth = 90}};
  records.room_errors = {{"a", {0.1, 1.0 / 3}, 2}};
  records.worst_rooms = {{"a", "den-007", "rooms/den-007", 0.75}};
  return records;
}

class EvaluationRecordsFile : public ::testing::Test {
 protected:
  EvaluationRecordsFile() : json_(nlohmann::ordered_json::parse(EvaluationRecordsJson(OneOfEach()))) {}

  EvaluationRecords Read() const {
    folder_.Write("records.json", json_.dump());
    return ReadEvaluationRecords(folder_ / "records.json");
  }
  void ExpectRefusedRecords(const std::vector<std::string>& texts) const {
    std::vector<std::string> all{"records.json", "armature eval"};
    all.insert(all.end(), texts.begin(), texts.end());
    testing::ExpectInputError([&] { Read(); }, all);
  }

  testing::TempFolder folder_;
  nlohmann::ordered_json json_;
};

TEST_F(EvaluationRecordsFile, ComesBackWithEveryDigit) {
  const EvaluationRecords records = Read();
  EXPECT_EQ(EvaluationRecordsJson(records), EvaluationRecordsJson(OneOfEach()));
  EXPECT_EQ(records.views.at(0).views_within_15_deg_share, 1.0 / 3);
  EXPECT_EQ(records.trajectories.at(0).alignment, AlignmentKind::kEndPoints);
  EXPECT_EQ(records.objects.at(0).approach, Approach::kObjectsNoLoopClosure);
  EXPECT_FALSE(records.retrieval.at(0).sequence);
}

TEST_F(EvaluationRecordsFile, ComesBackWithListsThatOnlySomeHave) {
  for (const char* list : {"detections", "rooms", "room_differences", "room_errors", "worst_rooms"})
    EXPECT_FALSE(json_.contains(list)) << list;
  const std::string written = EvaluationRecordsJson(WithDetectionsAndRooms());
  json_ = nlohmann::ordered_json::parse(written);
  const EvaluationRecords records = Read();
  EXPECT_EQ(EvaluationRecordsJson(records), written);
  EXPECT_EQ(records.detections.at(0).recall_share, 0.25);
  EXPECT_FALSE(records.rooms.at(0).high);
  EXPECT_EQ(records.room_differences.at(0).rooms_to_show_a_tenth, 90);
  EXPECT_EQ(records.room_errors.at(0).object_errors_m, (std::vector<double>{0.1, 1.0 / 3}));
  EXPECT_EQ(records.worst_rooms.at(0).error_m, 0.75);
  json_["rooms"][0].erase("low");
  ExpectRefusedRecords({"rooms[0]", "'low'"});
}

TEST_F(EvaluationRecordsFile, HasUnitsInItsKeysAndNullForWhatIsNotKnown) {
  EXPECT_EQ(json_["objects"][0]["object_error_mean_m"], 0.0625);
  EXPECT_EQ(json_["objects"][0]["approach"], "objects_no_loop_closure");
  EXPECT_TRUE(json_["objects"][0]["category"].is_null());
  EXPECT_TRUE(json_["objects"][0]["object_error_worst_m"].is_null());
  EXPECT_EQ(json_["trajectories"][0]["trajectory"], "odometry_scaled");
}

TEST_F(EvaluationRecordsFile, AMissingOrRenamedKeyIsNamed) {
  const auto whole = json_;
  json_["objects"][0].erase("found");
  ExpectRefusedRecords({"objects[0]", "'found'"});
  json_ = whole;
  json_["trajectories"][0].erase("ate_rmse_m");
  json_["trajectories"][0]["ate_rmse_cm"] = 10;
  ExpectRefusedRecords({"trajectories[0]", "'ate_rmse_m'"});
  json_ = whole;
  json_["views"][0].erase("category");  // null would be all of them
  ExpectRefusedRecords({"views[0]", "'category'"});
  json_ = whole;
  json_.erase("retrieval");
  ExpectRefusedRecords({"'retrieval'"});
}

TEST_F(EvaluationRecordsFile, WhatIsOfNoEnumerationOrKindIsRefused) {
  const auto whole = json_;
  json_["objects"][0]["approach"] = "objects, loop closure";
  ExpectRefusedRecords({"objects[0]", "approach", "'objects, loop closure'", "objects_loop_closure"});
  json_ = whole;
  json_["trajectories"][0]["alignment"] = "first_pos";
  ExpectRefusedRecords({"trajectories[0]", "alignment", "'first_pos'", "first_pose"});
  json_ = whole;
  json_["views"][0]["detections"] = "many";
  ExpectRefusedRecords({"views[0]", "number"});
  json_ = whole;
  json_["schema"] = 7;
  ExpectRefusedRecords({"schema 7"});
  json_ = {{"tables", whole["objects"]}};
  ExpectRefusedRecords({"'schema'"});
}

}  // namespace
}  // namespace armature
