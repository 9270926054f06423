// SPDX-License-Identifier: BSD-3-Clause
// Tables over rooms, of rooms made by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "eval/rooms/room_factors.h"
#include "eval/rooms/room_stability.h"
#include "eval/rooms/room_statistics.h"
#include "eval/rooms/worst_rooms.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

// Objects "chair-0", ...; an error below 0: missed.
EvaluatedRoom MakeRoom(const std::string& name, const std::vector<double>& errors) {
  EvaluatedRoom room{.room = name, .folder = "runs/" + name};
  for (size_t i = 0; i < errors.size(); ++i) {
    RoomObject object;
    object.of.category = "chair";
    object.of.true_id = "chair-" + std::to_string(i);
    object.of.status = errors[i] < 0 ? ObjectStatus::kMissed : ObjectStatus::kFound;
    if (errors[i] >= 0) {
      object.of.error = ObjectError{};
      object.of.error->centre_m = errors[i];
    }
    object.circumstances.distance_m = 1 + errors[i];
    room.objects.push_back(object);
  }
  return room;
}

RoomVariant MakeVariant(const std::string& name, double factor) {
  RoomVariant variant{name, {}};
  for (int i = 0; i < 12; ++i) {
    const double error = 0.1 + 0.01 * i;
    variant.rooms.push_back(MakeRoom("room-" + std::to_string(i), {factor * error, factor * 2 * error}));
  }
  return variant;
}

const RoomStatisticRecord& Statistic(const std::vector<RoomStatisticRecord>& records, const std::string& run,
                                     const std::string& key) {
  for (const RoomStatisticRecord& record : records)
    if (record.run == run && record.statistic == key) return record;
  throw std::out_of_range(key);
}

const RoomDifferenceRecord& Difference(const std::vector<RoomDifferenceRecord>& records,
                                       const std::string& key) {
  for (const RoomDifferenceRecord& record : records)
    if (record.statistic == key) return record;
  throw std::out_of_range(key);
}

TEST(RoomStatisticsTest, PoolObjectsAndGiveIntervals) {
  RoomVariant variant{"one", {MakeRoom("a", {0.1, -1}), MakeRoom("b", {0.2, 0.6})}};
  variant.rooms[0].spurious = 3;
  variant.rooms[0].log_scale = -0.5;
  variant.rooms[1].objects[0].of.error->orientation.azimuth_deg = -16;
  const auto records = ComputeRoomStatistics({variant});
  EXPECT_DOUBLE_EQ(*Statistic(records, "one", "found_share").value, 0.75);
  EXPECT_DOUBLE_EQ(*Statistic(records, "one", "spurious_per_room").value, 1.5);
  EXPECT_DOUBLE_EQ(*Statistic(records, "one", "object_error_median_m").value, 0.2);
  EXPECT_DOUBLE_EQ(*Statistic(records, "one", "object_error_mean_m").value, 0.3);
  EXPECT_DOUBLE_EQ(*Statistic(records, "one", "object_error_worst_m").value, 0.6);
  EXPECT_DOUBLE_EQ(*Statistic(records, "one", "log_scale_error_mean").value, 0.5);
  EXPECT_DOUBLE_EQ(*Statistic(records, "one", "azimuth_within_15_deg_share").value, 2.0 / 3);
  EXPECT_FALSE(Statistic(records, "one", "ate_rmse_mean_m").value) << "no room has cameras";
  EXPECT_DOUBLE_EQ(*Statistic(records, "one", "object_error_mean_m").low, 0.1) << "room a twice";
  EXPECT_DOUBLE_EQ(*Statistic(records, "one", "object_error_mean_m").high, 0.4) << "room b twice";
  const Table table = RoomTable({variant}, records);
  EXPECT_EQ(table.rows.at(0).at(5).text, "0.300 [0.100, 0.400]");
  EXPECT_EQ(table.rows[0].back().text, "");
}

TEST(RoomDifferencesTest, ArePairedByRoom) {
  RoomVariant a = MakeVariant("a", 1), b = MakeVariant("b", 1.1);
  b.rooms.erase(b.rooms.begin());  // room-0, which a alone has
  const auto records = CompareVariants(a, b);
  const auto& mean = Difference(records, "object_error_mean_m");
  EXPECT_EQ(mean.rooms, 11);
  EXPECT_NEAR(mean.mean_b / mean.mean_a, 1.1, 1e-9);
  EXPECT_EQ(mean.mark, "higher");
  EXPECT_EQ(mean.rooms_to_show_a_tenth, 2) << "all rooms differ by nearly the same";
  const auto& ln = Difference(records, "object_error_mean_ln_m");
  EXPECT_NEAR(ln.difference, std::log(1.1), 1e-9);
  EXPECT_EQ(Difference(records, "found_share").mark, "same");
  EXPECT_EQ(RoomDifferenceTable(records).rows.size(), records.size());
}

TEST(RoomDifferencesTest, AMethodIsNotBlamedForWhatOnlyItHasFound) {
  RoomVariant a{"a", {}}, b{"b", {}};
  for (int i = 0; i < 8; ++i) {
    a.rooms.push_back(MakeRoom("room-" + std::to_string(i), {0.1, -1}));
    b.rooms.push_back(MakeRoom("room-" + std::to_string(i), {0.1, 0.5}));
  }
  const auto records = CompareVariants(a, b);
  EXPECT_EQ(Difference(records, "object_error_mean_m").mark, "higher");
  EXPECT_EQ(Difference(records, "object_error_mean_found_by_both_m").difference, 0);
  EXPECT_EQ(Difference(records, "found_share").mark, "higher");
}

TEST(WorstRoomsTest, MissedAndSpuriousObjectsCountAsFarOff) {
  RoomVariant variant{"one",
                      {MakeRoom("good", {0.05, 0.05}), MakeRoom("far", {0.4, 0.4}),
                       MakeRoom("missing", {0.05, -1}), MakeRoom("spurious", {0.05, 0.05})}};
  variant.rooms[3].spurious = 2;
  const auto worst = FindWorstRooms(variant, 1);
  ASSERT_EQ(worst.size(), 4u);
  EXPECT_EQ(worst[0].sequence, "spurious");
  EXPECT_NEAR(worst[0].error_m, 1.05, 1e-12);
  EXPECT_EQ(worst[1].sequence, "missing");
  EXPECT_EQ(worst[2].sequence, "far");
  EXPECT_EQ(worst[2].folder, "runs/far");
  variant.rooms[1].log_scale = std::log(1.3);
  EXPECT_EQ(DescribeFaults(variant.rooms[1]), "scale 1.30 times, chair-1 0.40 m off, chair-0 0.40 m off");
  EXPECT_EQ(DescribeFaults(variant.rooms[2]), "1 of 2 missed");
  EXPECT_EQ(DescribeFaults(variant.rooms[0]), "");
}

TEST(WorstRoomsTest, AreTenAtMost) { EXPECT_EQ(FindWorstRooms(MakeVariant("a", 1), 1).size(), 10u); }

TEST(RoomFactorsTest, WhatGrowsWithTheErrorIsCorrelatedWithIt) {
  const Table table = RoomFactorTable(MakeVariant("a", 1));
  const auto& distance = table.rows.at(0);
  EXPECT_EQ(distance[0].text, "distance [m]");
  EXPECT_EQ(distance[2].text, "24");
  EXPECT_EQ(distance[3].text, "1.00");
  EXPECT_EQ(distance[4].text, "1.00");
  EXPECT_EQ(table.rows.size(), 1U) << "what is the same everywhere, or not known of any object, has no row";
}

TEST(RoomFactorsTest, MissedObjectsAreCountedByThirds) {
  RoomVariant variant{"a", {}};
  for (int i = 0; i < 9; ++i) {
    variant.rooms.push_back(MakeRoom("room-" + std::to_string(i), {i < 6 ? 0.1 : -1.0}));
    variant.rooms.back().objects[0].circumstances.distance_m = i;
  }
  const Table table = RoomFactorTable(variant);
  const auto& row = table.rows.at(0);
  EXPECT_EQ(row[11].text, "0");
  EXPECT_EQ(row[13].text, "100");
  EXPECT_EQ(row[10].text, "") << "none was found there";
}

TEST(RoomGroupsTest, AreCategoriesAndDetectionSettings) {
  RoomVariant variant{"a", {MakeRoom("x", {0.1, 0.3}), MakeRoom("y", {-1})}};
  variant.rooms[0].circumstances.detections = "network";
  variant.rooms[0].circumstances.path = variant.rooms[1].circumstances.path = "turn";
  variant.rooms[0].spurious = 3;
  variant.rooms[0].log_scale = -0.25;
  variant.rooms[1].log_scale.reset();
  const Table table = RoomGroupTable(variant);
  ASSERT_EQ(table.rows.size(), 4u);
  EXPECT_EQ(table.rows[0][1].text, "chair");
  EXPECT_EQ(table.rows[0][3].text, "66.7");
  EXPECT_EQ(table.rows[1][1].text, "network");
  EXPECT_EQ(table.rows[1][4].text, "0.200");
  EXPECT_EQ(table.rows[2][1].text, "unknown");
  EXPECT_EQ(table.rows[0][6].text, "") << "rooms are of no category";
  EXPECT_EQ(table.rows[3][1].text, "turn");
  EXPECT_EQ(table.rows[3][6].text, "2");
  EXPECT_EQ(table.rows[3][7].text, "1.50");
  EXPECT_EQ(table.rows[3][8].text, "0.250");
}

RoomVariant Jittered(const std::string& name, int seed, double error, int spurious) {
  RoomVariant variant{name, {MakeRoom("x", {error}), MakeRoom("y", {0.1})}};
  for (EvaluatedRoom& room : variant.rooms) room.jitter = seed;
  variant.rooms[0].spurious = spurious;
  return variant;
}

TEST(StabilityTest, IsTheSpreadOfRepeatsOfARoom) {
  std::vector<RoomVariant> variants{Jittered("a", 0, 0.1, 0), Jittered("a-1", 1, 0.2, 1),
                                    Jittered("a-2", 2, 0.3, 0), Jittered("b", 0, 0.1, 0)};
  const auto repeated = TakeRepeats(variants);
  ASSERT_EQ(variants.size(), 2u);
  EXPECT_EQ(variants[1].name, "b");
  ASSERT_EQ(repeated.size(), 1u) << "b was not repeated";
  EXPECT_EQ(repeated[0].repeats.size(), 3u);
  const Table table = StabilityTable(repeated);
  const auto& row = table.rows.at(0);
  EXPECT_EQ(row[3].text, "0.0500") << "of 0.1 in one room and 0 in the other";
  EXPECT_EQ(row[4].text, "0.1000");
  EXPECT_EQ(row[7].text, "0.0");
  EXPECT_EQ(row[8].text, "50.0");
}

TEST(StabilityTest, AVariantThatIsOnlyNamedLikeARepeatIsNone) {
  std::vector<RoomVariant> variants{Jittered("a", 0, 0.1, 0), Jittered("a-1", 0, 0.2, 1)};
  EXPECT_TRUE(TakeRepeats(variants).empty());
  EXPECT_EQ(variants.size(), 2u);
}

TEST(RawRoomsTest, AreARowEach) {
  const std::string objects = RawRoomObjectsCsv({{"a", {MakeRoom("x,y", {0.25, -1})}}});
  EXPECT_NE(objects.find("a,\"x,y\",0,chair-0,chair,found,0.25,"), std::string::npos) << objects;
  EXPECT_NE(objects.find("chair-1,chair,missed,,,,"), std::string::npos) << objects;
  const std::string rooms = RawRoomsCsv({{"a", {MakeRoom("x", {0.25, -1})}}});
  EXPECT_NE(rooms.find("a,x,0,2,1,0,0.25,,,"), std::string::npos) << rooms;
}

// A camera that moves along x and looks along z at a chair 4 m away; y of objects is against gravity.
SequenceTruth CorridorTruth() {
  SequenceTruth sequence;
  sequence.camera = {.width = 640, .height = 480, .fx = 400, .fy = 400, .cx = 320, .cy = 240};
  for (int i = 0; i < 3; ++i) {
    TimedPose camera{.timestamp = static_cast<double>(i)};
    camera.pose.translation() << -3 + 3 * i, 0, 0;
    sequence.truth.T_world_camera.push_back(camera);
    sequence.truth.detections[{1000000LL * i, 0}] = 0;
  }
  TrueObject chair{"chair-1", "chair", ""};
  chair.T_world_object.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();  // y up is -y of the camera
  chair.T_world_object.translation() << 0, 0.6, 4;
  chair.size << 0.5, 0.8, 0.5;
  sequence.truth.objects = {chair};
  return sequence;
}

CategoryModel ChairModel() {
  CategoryModel model;
  model.spec.name = "chair";
  model.spec.edge_names = {"one"};
  model.mean = Eigen::VectorXd(6);
  model.mean << 0, 0, 0, 0.5, 0.8, 0.5;  // a single edge across the box
  return model;
}

TEST(CircumstancesTest, AreThoseOfTheViews) {
  const SequenceTruth sequence = CorridorTruth();
  const ObjectCircumstances chair = DescribeObjects(sequence, {ChairModel()}).at(0);
  EXPECT_EQ(chair.views, 3);
  EXPECT_NEAR(*chair.distance_m, std::sqrt(9 + 0.36 + 16), 1e-9) << "the middle of three";
  const double far = 9 + 0.36 + 16;
  EXPECT_NEAR(*chair.parallax_deg, std::acos((far - 18) / far) * 180 / M_PI, 1e-6);
  EXPECT_TRUE(chair.was_whole);
  EXPECT_NEAR(chair.size_deviation, 0, 1e-12);
  EXPECT_FALSE(chair.hidden_share) << "without true edges";
}

TEST(CircumstancesTest, AnObjectThatIsCutInAllViewsWasNeverWhole) {
  SequenceTruth sequence = CorridorTruth();
  sequence.truth.objects[0].size.x() = 20;
  const ObjectCircumstances wide = DescribeObjects(sequence, {ChairModel()}).at(0);
  EXPECT_FALSE(wide.was_whole);
  EXPECT_NEAR(wide.size_deviation, std::log(40.0) / 3, 1e-12);
}

TEST(CircumstancesTest, WithoutKnownDetectionsImagesWithTheCentreAreViews) {
  SequenceTruth sequence = CorridorTruth();
  sequence.truth.T_world_camera[0].pose.translation().x() = -30;  // out of sight
  EXPECT_EQ(DescribeObjects(sequence, {ChairModel()}).at(0).views, 3);
  sequence.truth.knows_detections = false;
  EXPECT_EQ(DescribeObjects(sequence, {ChairModel()}).at(0).views, 2);
}

TEST(CircumstancesTest, OfARoomAreItsCameras) {
  SequenceTruth sequence = CorridorTruth();
  const RoomCircumstances room = DescribeRoom(sequence, "/nowhere");
  EXPECT_EQ(room.images, 3);
  EXPECT_NEAR(room.path_m, 6, 1e-12);
  EXPECT_NEAR(*room.pitch_deg, 0, 1e-9);
  EXPECT_NEAR(*room.camera_height_m, 1.0, 1e-9) << "0.6 m above the centre, half of 0.8 m above its base";
  EXPECT_EQ(room.detections, "");
  const testing::TempFolder folder;
  folder.Write("scene.yaml", "detections: {setting: network}\npath: {kind: turn}\n");
  const RoomCircumstances known = DescribeRoom(CorridorTruth(), folder.path());
  EXPECT_EQ(known.detections, "network");
  EXPECT_EQ(known.path, "turn");
}

}  // namespace
}  // namespace armature
