// SPDX-License-Identifier: BSD-3-Clause
// Maps with known errors against a known truth.
#include <gtest/gtest.h>

#include <algorithm>

#include "eval/objects/run_objects.h"
#include "support/expect_input_error.h"
#include "support/shared_data.h"
#include "support/true_map.h"

namespace armature {
namespace {

using testing::ExpectInputError;
using testing::MapText;
using testing::SameName;
using testing::TrajectoryText;
using testing::TrueMap;
using testing::TrueWorld;
using testing::Unchanged;

const Eigen::Vector3d kChairSize(0.4, 0.9, 0.5), kTableSize(1.6, 0.74, 0.8);

TrueObject ObjectAt(const std::string& id, const std::string& category, const Eigen::Vector3d& place) {
  TrueObject object{id, category, ""};
  object.T_world_object.linear() = ExpSO3({0.1 * place.x(), 2 * place.y(), 0.3});  // any
  object.T_world_object.translation() = place;
  object.size = category == "table" ? kTableSize : kChairSize;
  return object;
}

// Three chairs and a table, all of them detected.
GroundTruth Room() {
  GroundTruth truth;
  truth.objects = {ObjectAt("chair0", "chair", {0, 0, 0}), ObjectAt("chair1", "chair", {0.8, 0, 0}),
                   ObjectAt("chair2", "chair", {5, 0, 1}), ObjectAt("table0", "table", {0.2, 0, 2})};
  for (size_t i = 0; i < truth.objects.size(); ++i) truth.detections[{0, static_cast<int>(i)}] = i;
  return truth;
}

std::vector<EvaluatedObject> Evaluate(const std::vector<PlacedObject>& map, const GroundTruth& truth,
                                      double gate_m = 1) {
  static const std::vector<CategorySpec> specs = testing::ShippedSpecs();
  return EvaluateObjects(map, truth, specs, MatchByDistance(map, truth.objects, gate_m));
}

void ExpectPerfect(const std::vector<EvaluatedObject>& objects, double tolerance) {
  for (const EvaluatedObject& object : objects) {
    ASSERT_EQ(object.status, ObjectStatus::kFound) << object.true_id << object.map_id;
    EXPECT_EQ(object.map_id, "map_" + object.true_id);
    EXPECT_NEAR(object.error->centre_m, 0, tolerance);
    EXPECT_NEAR(object.error->orientation.azimuth_deg, 0, 1e3 * tolerance);
    EXPECT_NEAR(object.error->orientation.tilt_deg, 0, 1e3 * tolerance);
    EXPECT_NEAR(object.error->size_m.norm(), 0, tolerance);
    EXPECT_NEAR(object.error->iou, 1, 1e2 * tolerance);
  }
}

std::string MatchOf(const std::vector<EvaluatedObject>& objects, const std::string& true_id) {
  for (const EvaluatedObject& object : objects) {
    if (object.true_id == true_id) return object.map_id;
  }
  return "no such object";
}

TEST(EvalObjects, TruthAsResultIsPerfect) {
  const GroundTruth truth = Room();
  const std::vector<EvaluatedObject> objects = Evaluate(TrueMap(truth), truth);
  ASSERT_EQ(objects.size(), 4u);
  ExpectPerfect(objects, 1e-12);
  const ObjectSummary summary = Summarise(objects, "");
  EXPECT_EQ(summary.found, 4);
  EXPECT_EQ(summary.observed, 4);
  EXPECT_EQ(summary.missed + summary.spurious, 0);
  EXPECT_EQ(summary.worst_m, 0);
  EXPECT_EQ(summary.average_size_m, 0);
}

TEST(EvalObjects, TheOrderOfTheMapDoesNotMatter) {
  const GroundTruth truth = Room();
  std::vector<PlacedObject> map = TrueMap(truth);
  std::reverse(map.begin(), map.end());
  ExpectPerfect(Evaluate(map, truth), 1e-12);
}

TEST(EvalObjects, KnownErrors) {
  GroundTruth truth = Room();
  truth.objects.resize(1);
  truth.detections = {{{0, 0}, 0}};
  std::vector<PlacedObject> map = TrueMap(truth);
  map[0].T_world_object.pretranslate(Eigen::Vector3d(0.03, 0, -0.04));
  map[0].T_world_object.rotate(Eigen::AngleAxisd(-30 * kDegree, Eigen::Vector3d::UnitY()));
  map[0].T_world_object.rotate(Eigen::AngleAxisd(6 * kDegree, Eigen::Vector3d::UnitX()));
  map[0].size += Eigen::Vector3d(0.1, -0.05, 0);
  const std::vector<EvaluatedObject> objects = Evaluate(map, truth);
  ASSERT_EQ(objects.size(), 1u);
  const ObjectError& error = objects[0].error.value();
  EXPECT_NEAR(error.centre_m, 0.05, 1e-12);
  EXPECT_NEAR(error.orientation.azimuth_deg, -30, 1e-9);
  EXPECT_NEAR(error.orientation.pitch_deg, 6, 1e-9);
  EXPECT_NEAR(error.orientation.roll_deg, 0, 1e-9);
  EXPECT_TRUE(error.size_m.isApprox(Eigen::Vector3d(0.1, -0.05, 0)));
  EXPECT_NEAR(error.mean_size_m(), 0.05, 1e-12);
  EXPECT_GT(error.iou, 0.5);
  EXPECT_LT(error.iou, 0.9);
  const ObjectSummary summary = Summarise(objects, "");
  EXPECT_NEAR(summary.average_azimuth_deg, 30, 1e-9) << "absolute";
  EXPECT_EQ(summary.best_m, summary.worst_m);
}

TEST(EvalObjects, CommonVolumeOfShiftedBoxes) {
  GroundTruth truth = Room();
  std::vector<PlacedObject> map = TrueMap(truth);
  map[3].T_world_object.translate(Eigen::Vector3d(kTableSize.x() / 2, 0, 0));
  EXPECT_NEAR(Evaluate(map, truth)[3].error->iou, 1.0 / 3, 1e-9);
}

TEST(EvalObjects, HalfATurnIsWrongForAChairAndNothingForATable) {
  const GroundTruth truth = Room();
  std::vector<PlacedObject> map = TrueMap(truth);
  for (PlacedObject& object : map)
    object.T_world_object.rotate(Eigen::AngleAxisd(180 * kDegree, Eigen::Vector3d::UnitY()));
  for (const EvaluatedObject& object : Evaluate(map, truth)) {
    EXPECT_NEAR(std::abs(object.error->orientation.azimuth_deg), object.category == "chair" ? 180 : 0, 1e-9);
    EXPECT_NEAR(object.error->size_m.norm(), 0, 1e-12);
    EXPECT_NEAR(object.error->iou, 1, 1e-9);
  }
}

// A square table of four equal sides, its two estimated sides a little different: they are compared with the
// true sides that they lie along.
TEST(EvalObjects, SizesUnderTheNearestSymmetricTurn) {
  TrueObject truth = ObjectAt("table0", "table", {0, 0, 0});
  truth.size = {1.0, 0.7, 1.1};
  PlacedObject object{"t", "table", "", truth.T_world_object, {1.1, 0.7, 1.0}, 1, {}};
  object.T_world_object.rotate(Eigen::AngleAxisd(90 * kDegree, Eigen::Vector3d::UnitY()));
  const ObjectError error = CompareObject(object, truth, 4);
  EXPECT_NEAR(error.orientation.azimuth_deg, 0, 1e-9);
  EXPECT_NEAR(error.size_m.norm(), 0, 1e-12);
  EXPECT_NEAR(error.iou, 1, 1e-9);
  EXPECT_GT(CompareObject(object, truth, 2).size_m.norm(), 0.1) << "a quarter turn is an error";
}

TEST(EvalObjects, MissedNeverObservedAndSpurious) {
  GroundTruth truth = Room();
  truth.detections.erase({0, 2});  // chair2
  std::vector<PlacedObject> map = TrueMap(truth);
  map[0].T_world_object.translation().y() += 3;  // chair0
  map.erase(map.begin() + 2);
  const std::vector<EvaluatedObject> objects = Evaluate(map, truth);
  ASSERT_EQ(objects.size(), 5u);
  EXPECT_EQ(objects[0].status, ObjectStatus::kMissed);
  EXPECT_EQ(objects[1].status, ObjectStatus::kFound);
  EXPECT_EQ(objects[2].status, ObjectStatus::kNeverObserved);
  EXPECT_EQ(objects[4].status, ObjectStatus::kSpurious);
  EXPECT_EQ(objects[4].map_id, "map_chair0");
  const ObjectSummary summary = Summarise(objects, "");
  EXPECT_EQ(summary.objects, 4);
  EXPECT_EQ(summary.observed, 3);
  EXPECT_EQ(summary.found, 2);
  EXPECT_EQ(summary.missed, 1);
  EXPECT_EQ(summary.spurious, 1);
  EXPECT_EQ(Summarise(objects, "table").missed, 0);
}

TEST(EvalObjects, TheGateIsTheFurthestMatch) {
  const GroundTruth truth = Room();
  std::vector<PlacedObject> map = {TrueMap(truth)[2]};
  map[0].T_world_object.translation().x() += 0.999;
  EXPECT_EQ(Summarise(Evaluate(map, truth), "").found, 1);
  map[0].T_world_object.translation().x() += 0.002;
  EXPECT_EQ(Summarise(Evaluate(map, truth), "").found, 0);
  EXPECT_EQ(Summarise(Evaluate(map, truth, 1.5), "").found, 1);
}

TEST(EvalObjects, OtherCategoriesAreNoMatch) {
  const GroundTruth truth = Room();
  std::vector<PlacedObject> map = TrueMap(truth);
  map[3].category = "laptop";
  const ObjectSummary summary = Summarise(Evaluate(map, truth), "");
  EXPECT_EQ(summary.found, 3);
  EXPECT_EQ(summary.missed, 1);
  EXPECT_EQ(summary.spurious, 1);
}

// Both are nearest to chair1; one chair each leaves none without.
TEST(EvalObjects, EachObjectIsMatchedOnce) {
  GroundTruth truth = Room();
  std::vector<PlacedObject> map = {TrueMap(truth)[0], TrueMap(truth)[1]};
  map[0].T_world_object.translation().x() = 0.7;
  map[1].T_world_object.translation().x() = 0.9;
  const std::vector<EvaluatedObject> objects = Evaluate(map, truth);
  EXPECT_EQ(MatchOf(objects, "chair0"), "map_chair0");
  EXPECT_EQ(MatchOf(objects, "chair1"), "map_chair1");
}

TEST(EvalObjects, ASecondOneOfTheSameIsSpurious) {
  GroundTruth truth = Room();
  std::vector<PlacedObject> map = TrueMap(truth);
  map.push_back(map[2]);
  map.back().id = "again";
  map.back().T_world_object.translation().x() += 0.01;
  const std::vector<EvaluatedObject> objects = Evaluate(map, truth);
  EXPECT_EQ(MatchOf(objects, "chair2"), "map_chair2");
  EXPECT_EQ(Summarise(objects, "").spurious, 1);
}

TEST(EvalObjects, EmptyMapsAndTruths) {
  const ObjectSummary nothing_found = Summarise(Evaluate({}, Room()), "");
  EXPECT_EQ(nothing_found.found, 0);
  EXPECT_EQ(nothing_found.missed, 4);
  const ObjectSummary nothing_there = Summarise(Evaluate(TrueMap(Room()), GroundTruth()), "");
  EXPECT_EQ(nothing_there.spurious, 4);
  EXPECT_EQ(nothing_there.objects, 0);
  EXPECT_TRUE(Evaluate({}, GroundTruth()).empty());
}

TEST(EvalObjects, SummaryOfDistances) {
  GroundTruth truth = Room();
  std::vector<PlacedObject> map = TrueMap(truth);
  const double distances[] = {0.1, 0.2, 0.9, 0.4};
  for (size_t i = 0; i < 4; ++i) map[i].T_world_object.translation().y() += distances[i];
  const ObjectSummary summary = Summarise(Evaluate(map, truth), "");
  EXPECT_NEAR(summary.best_m, 0.1, 1e-12);
  EXPECT_NEAR(summary.worst_m, 0.9, 1e-12);
  EXPECT_NEAR(summary.average_m, 0.4, 1e-12);
  EXPECT_NEAR(summary.median_m, 0.3, 1e-12);
  EXPECT_NEAR(Summarise(Evaluate(map, truth), "chair").median_m, 0.2, 1e-12);
}

RunResults ObservationsOf(const std::vector<std::string>& objects) {
  RunResults run;
  for (size_t i = 0; i < objects.size(); ++i) {
    const int index = static_cast<int>(i);
    run.observations[{0, index}] = {0, index, "ok", std::nullopt, {}, objects[i]};
  }
  return run;
}

// However far away it is, and though another chair's place is nearer.
TEST(EvalObjects, MatchedByDetections) {
  const GroundTruth truth = Room();  // detection i is of object i
  std::vector<PlacedObject> map = TrueMap(truth);
  std::swap(map[0].T_world_object, map[2].T_world_object);
  const RunResults run = ObservationsOf({"map_chair0", "map_chair1", "map_chair2", "map_table0"});
  const ObjectPairs pairs = MatchByDetections(map, run, truth);
  EXPECT_EQ(pairs, (ObjectPairs{{0, 0}, {1, 1}, {2, 2}, {3, 3}}));
}

TEST(EvalObjects, MostDetectionsDecide) {
  GroundTruth truth = Room();
  truth.detections = {{{0, 0}, 0}, {{0, 1}, 0}, {{0, 2}, 1}, {{0, 3}, 1}, {{0, 4}, 1}, {{0, 5}, 3}};
  const std::vector<PlacedObject> map = TrueMap(truth);
  // map_chair0 is of chair0 twice and of chair1 once; map_chair1 and map_chair2 are both of chair1, once
  // each; a chair's box may hold a table.
  const RunResults run = ObservationsOf(
      {"map_chair0", "map_chair0", "map_chair0", "map_chair1", "map_chair2", "map_chair2", ""});
  EXPECT_EQ(MatchByDetections(map, run, truth), (ObjectPairs{{0, 0}, {1, 1}}));
  EXPECT_TRUE(MatchByDetections(map, RunResults(), truth).empty());
  EXPECT_TRUE(MatchByDetections({}, RunResults(), truth).empty());
  testing::ExpectInputError([&] { MatchByDetections({}, run, truth); }, {"observations.csv", "'map_chair0'"});
}

class RunMaps : public ::testing::Test {
 protected:
  // The evaluation of a run whose map and trajectory are the true ones in another world.
  RunObjects EvaluateIn(const Similarity& T_run_truth, AlignmentKind alignment) const {
    const auto run = world_.WriteRun("run", Unchanged, SameName);
    WriteMap(world_, "run", TrueMap(world_.sequence.truth), T_run_truth);
    ObjectEvaluationOptions options;
    options.alignment = alignment;
    return EvaluateRunObjects(LoadRun(run), world_.sequence, world_.specs, options);
  }

  TrueWorld world_;
};

TEST_F(RunMaps, TruthAsResultIsPerfect) {
  const RunObjects objects = EvaluateIn(Similarity(), AlignmentKind::kNone);
  ASSERT_EQ(objects.maps.size(), 2u);
  for (const EvaluatedMap& map : objects.maps) ExpectPerfect(map.by_distance, 1e-9);
  EXPECT_EQ(objects.maps[0].approach, Approach::kOdometryOnly);
  EXPECT_EQ(objects.maps[1].approach, Approach::kObjects);
  EXPECT_TRUE(objects.maps[1].by_detections.empty()) << "observations name no objects";
}

TEST_F(RunMaps, AnotherWorldIsMovedToTheTruth) {
  Similarity moved;
  moved.R = ExpSO3({1, -0.4, 2});
  moved.t = {3, -7, 12};
  for (const AlignmentKind kind : {AlignmentKind::kFirstPose, AlignmentKind::kSe3, AlignmentKind::kSim3}) {
    for (const EvaluatedMap& map : EvaluateIn(moved, kind).maps) ExpectPerfect(map.by_distance, 1e-6);
  }
  EXPECT_EQ(Summarise(EvaluateIn(moved, AlignmentKind::kNone).maps[1].by_distance, "").found, 0);
}

// Centres and sizes are scaled alike, and only where the alignment says so.
TEST_F(RunMaps, AScaleIsAnErrorUnlessItIsFitted) {
  Similarity scaled;
  scaled.scale = 0.8;
  scaled.R = ExpSO3({1, -0.4, 2});
  const RunObjects fitted = EvaluateIn(scaled, AlignmentKind::kSim3);
  EXPECT_NEAR(fitted.maps[1].T_truth_run.scale, 1.25, 1e-9);
  ExpectPerfect(fitted.maps[1].by_distance, 1e-6);
  const RunObjects metric = EvaluateIn(scaled, AlignmentKind::kFirstPose);
  EXPECT_EQ(metric.maps[1].T_truth_run.scale, 1);
  for (const EvaluatedObject& object : metric.maps[1].by_distance) {
    ASSERT_TRUE(object.error) << object.true_id;
    EXPECT_GT(object.error->centre_m, 0.1);
    EXPECT_LT(object.error->size_m.maxCoeff(), -0.05);
  }
}

TEST_F(RunMaps, OdometryIsMovedByItsOwnTrajectory) {
  const auto run = world_.WriteRun("run", Unchanged, SameName);
  WriteMap(world_, "run", TrueMap(world_.sequence.truth), Similarity());
  Similarity moved;
  moved.t = {0.3, 0, 0};
  world_.folder.Write("run/odometry_scaled.txt", TrajectoryText(world_.sequence.truth, moved));
  const RunObjects objects = EvaluateRunObjects(LoadRun(run), world_.sequence, world_.specs, {});
  EXPECT_NEAR(Summarise(objects.maps[0].by_distance, "").average_m, 0.3, 1e-9);
  EXPECT_NEAR(Summarise(objects.maps[1].by_distance, "").average_m, 0, 1e-9);
}

TEST_F(RunMaps, OlderRunsHaveNone) {
  const auto run = world_.WriteRun("run", Unchanged, SameName);
  EXPECT_TRUE(EvaluateRunObjects(LoadRun(run), world_.sequence, world_.specs, {}).maps.empty());
}

TEST_F(RunMaps, AMapWithoutObjects) {
  const auto run = world_.WriteRun("run", Unchanged, SameName);
  WriteMap(world_, "run", {}, Similarity());
  const RunObjects objects = EvaluateRunObjects(LoadRun(run), world_.sequence, world_.specs, {});
  ASSERT_EQ(objects.maps.size(), 2u);
  EXPECT_EQ(Summarise(objects.maps[1].by_distance, "").missed, 2);
  world_.folder.Write("run/trajectory.txt", "# no odometry, no pose\n");
  EXPECT_NO_THROW(EvaluateRunObjects(LoadRun(run), world_.sequence, world_.specs, {}));
}

TEST_F(RunMaps, ApproachesByConfiguration) {
  const auto run = world_.WriteRun("run", Unchanged, SameName);
  WriteMap(world_, "run", {}, Similarity());
  const auto evaluate = [&](const std::string& configuration) {
    world_.folder.Write("run/config.yaml", configuration);
    return EvaluateRunObjects(LoadRun(run), world_.sequence, world_.specs, {});
  };
  RunObjects objects = evaluate("resection:\n  normal_term: none\nmapping:\n  loop_closure: true\n");
  EXPECT_EQ(objects.maps[1].approach, Approach::kObjectsLoopClosure);
  EXPECT_EQ(objects.configuration.normal_term, "none");
  objects = evaluate("mapping:\n  loop_closure: false\n");
  EXPECT_EQ(objects.maps[0].approach, Approach::kOdometryOnly);
  EXPECT_EQ(objects.maps[1].approach, Approach::kObjectsNoLoopClosure);
  EXPECT_FALSE(objects.configuration.normal_term);
  ExpectInputError([&] { evaluate("mapping:\n  loop_closure: perhaps\n"); },
                   {"config.yaml:2", "loop_closure"});
}

TEST_F(RunMaps, BadInput) {
  const auto run = world_.WriteRun("run", Unchanged, SameName);
  const auto evaluate = [&] { EvaluateRunObjects(LoadRun(run), world_.sequence, world_.specs, {}); };
  WriteMap(world_, "run", TrueMap(world_.sequence.truth), Similarity());
  world_.folder.Write("run/trajectory.txt", "100.0 0 0 0 0 0 0 1\n");
  ExpectInputError(evaluate, {"trajectory.txt", "world"});
  std::filesystem::remove(run / "trajectory.txt");
  ExpectInputError(evaluate, {"trajectory.txt", "cannot be opened"});
}

// Real rooms, some of whose objects are in no detection.
TEST(EvalObjects, SharedTruthsAsResultsArePerfect) {
  for (const char* name : {"sequences/office_dev", "sequences/redkitchen_a"}) {
    ARMATURE_SHARED_DATA_OR_SKIP(folder, name);
    const GroundTruth truth = LoadGroundTruth(folder);
    ExpectPerfect(Evaluate(TrueMap(truth), truth), 1e-9);
    const ObjectSummary none = Summarise(Evaluate({}, truth), "");
    EXPECT_LE(none.missed, none.objects);
    EXPECT_GE(none.missed, 5);
    EXPECT_FALSE(truth.objects_source.empty());
  }
}

TEST(PlacedObjects, BadInput) {
  const testing::TempFolder folder;
  const std::string header = MapText({}), good = "a,chair,,0,0,0,0,0,0,1,0.4,0.9,0.5,3,0.5;-1\n";
  const auto refused = [&](const std::string& text, const std::vector<std::string>& expected) {
    const auto file = folder.Write("objects.csv", text);
    ExpectInputError([&] { ReadPlacedObjects(file); }, expected);
  };
  const auto objects = ReadPlacedObjects(folder.Write("objects.csv", header + good));
  ASSERT_EQ(objects.size(), 1u);
  EXPECT_EQ(objects[0].shape, (std::vector<double>{0.5, -1}));
  EXPECT_EQ(objects[0].observations, 3);
  EXPECT_TRUE(ReadPlacedObjects(folder.Write("objects.csv", header)).empty());
  refused(header + good + good, {"objects.csv:3", "'a'", "twice"});
  refused(header + "a,chair,,0,0,0,0,0,0,2,0.4,0.9,0.5,3,\n", {"objects.csv:2", "quaternion"});
  refused(header + "a,chair,,0,0,x,0,0,0,1,0.4,0.9,0.5,3,\n", {"objects.csv:2", "'tz'", "'x'"});
  refused(header + "a,chair,,0,0,0,0,0,0,1,-0.4,0.9,0.5,3,\n", {"objects.csv:2", "size"});
  refused(header + "a,chair,,0,0,0,0,0,0,1,0.4,0.9,0.5,-3,\n", {"objects.csv:2", "observations"});
  refused(header + "a,chair,,0,0,0,0,0,0,1,0.4,0.9,0.5,3,1;y\n", {"objects.csv:2", "shape", "'y'"});
  refused(header + ",chair,,0,0,0,0,0,0,1,0.4,0.9,0.5,3,\n", {"objects.csv:2", "id"});
  refused("id,category\n", {"objects.csv:1", "instance"});
  ExpectInputError([&] { ReadPlacedObjects(folder / "absent.csv"); }, {"absent.csv"});
}

TEST(PlacedObjects, BadInputOfWhatIsUnsure) {
  const testing::TempFolder folder;
  std::string header = MapText({});
  header.insert(header.find('\n'), ",probability,covariance");
  const std::string good = "a,chair,,0,0,0,0,0,0,1,0.4,0.9,0.5,3,0.5;-1,";
  const auto refused = [&](const std::string& row, const std::vector<std::string>& expected) {
    const auto file = folder.Write("objects.csv", header + good + row + "\n");
    ExpectInputError([&] { ReadPlacedObjects(file); }, expected);
  };
  const auto unknown = ReadPlacedObjects(folder.Write("objects.csv", header + good + ",\n"));
  EXPECT_FALSE(unknown[0].probability || unknown[0].covariance);
  refused("1.5,", {"objects.csv:2", "probability", "from 0 to 1"});
  refused("-0.1,", {"objects.csv:2", "probability"});
  refused("0.5,1;2;3", {"objects.csv:2", "covariance", "45"});
  refused("0.5,1;x", {"objects.csv:2", "covariance", "'x'"});
  std::string zeros = "0";
  for (int i = 1; i < 45; ++i) zeros += ";0";
  refused("0.5," + zeros, {"objects.csv:2", "covariance", "positive definite"});
}

}  // namespace
}  // namespace armature
