// SPDX-License-Identifier: BSD-3-Clause
// Maps of synthetic rooms whose true cameras and furniture are known.
#include "mapping/solve_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/viewpoint.h"
#include "mapping/object_map.h"
#include "support/map_world.h"

namespace armature {
namespace {

using testing::FurnishRoom;
using testing::MapWorld;
using testing::TrueFurniture;
using testing::WorldNoise;

Map Solve(const std::vector<MapFrame>& frames, const ScaleEstimate& expected, const MappingOptions& options) {
  return SolveMap(frames, expected, BoxOptions{}, ResectionOptions{}, options);
}

// Root mean square distance of the cameras from the true ones, metres.
double TrajectoryError(const std::vector<Eigen::Isometry3d>& cameras, const MapWorld& world) {
  double sum = 0;
  for (size_t i = 0; i < cameras.size(); ++i) {
    sum += (cameras[i].translation() - world.T_world_camera[i].translation()).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(cameras.size()));
}

// The map's object nearest to a true one of its category; null: none within 0.8 m.
const MapObject* Nearest(const Map& map, const TrueFurniture& truth) {
  const MapObject* nearest = nullptr;
  double least = 0.8;
  for (const MapObject& object : map.objects) {
    const double distance = (object.T_world_object.translation() - truth.T_world_object.translation()).norm();
    if (object.model != truth.model || distance > least) continue;
    least = distance;
    nearest = &object;
  }
  return nearest;
}

double TurnError(const MapObject& object, const TrueFurniture& truth) {
  return std::abs(AzimuthDifference(YawBetween(truth.T_world_object, object.T_world_object), 0,
                                    truth.model->spec.symmetry_order)) /
         kDegree;
}

// The worst of all true objects.
struct ObjectErrors {
  double metres = 0, turn_deg = 0, size = 0;
};

ObjectErrors ErrorsOf(const Map& map, const MapWorld& world) {
  ObjectErrors worst;
  for (const TrueFurniture& truth : world.furniture) {
    const MapObject* object = Nearest(map, truth);
    if (!object) return {99, 180, 99};
    const Eigen::Vector3d apart = object->T_world_object.translation() - truth.T_world_object.translation();
    worst.metres = std::max(worst.metres, apart.norm());
    worst.turn_deg = std::max(worst.turn_deg, TurnError(*object, truth));
    const Eigen::Vector3d size =
        BoundingBoxSize(WireframeFromCoefficients(*truth.model, truth.coefficients)) +
        2 * truth.model->spec.padding;
    worst.size = std::max(worst.size, (object->Size() - size).cwiseAbs().maxCoeff());
  }
  return worst;
}

// Of the map's objects, no more and no fewer, and its cameras.
void ExpectTrueMap(const Map& map, const MapWorld& world, double metres, double turn_deg, double trajectory) {
  EXPECT_EQ(map.objects.size(), world.furniture.size());
  const ObjectErrors errors = ErrorsOf(map, world);
  EXPECT_LT(errors.metres, metres);
  EXPECT_LT(errors.size, metres);
  EXPECT_LT(errors.turn_deg, turn_deg);
  EXPECT_LT(TrajectoryError(map.T_world_camera, world), trajectory);
}

constexpr double kUnit = 2.65;            // metres a unit of odometry
const ScaleEstimate kExpected{2.5, 0.1};  // what the front end has learnt of it

constexpr WorldNoise kNoise{.segment_pixels = 0.7, .depth = 0.06, .yaw_deg = 4, .shape = 0.5, .unit = kUnit};

TEST(SolveMap, PerfectViewsGiveTheTrueMap) {
  MapWorld world;
  FurnishRoom(world);
  world.Put("laptop", -0.4, 2.2, 170, 0, 0.5);
  const Map map = Solve(world.Frames({.unit = kUnit}), kExpected, {});
  ExpectTrueMap(map, world, 0.02, 0.3, 0.01);
  EXPECT_NEAR(map.MeanScale(), kUnit, 0.01 * kUnit);
}

TEST(SolveMap, NoiseAveragesOut) {
  MapWorld world;
  FurnishRoom(world);
  const Map map = Solve(world.Frames(kNoise), kExpected, {});
  ExpectTrueMap(map, world, 0.03, 1, 0.01);
  ASSERT_TRUE(map.scale_sigma);
  EXPECT_LT(*map.scale_sigma, 0.08);  // mostly what is unknown of the sizes of three objects
  EXPECT_LT(std::abs(std::log(map.MeanScale() / kUnit)), 3 * *map.scale_sigma);
}

TEST(SolveMap, StartsFromAnyScale) {
  MapWorld world;
  FurnishRoom(world);
  const Map map = Solve(world.Frames({.unit = kUnit}), {1.8, 1.0}, {});
  ExpectTrueMap(map, world, 0.03, 0.5, 0.02);
  EXPECT_NEAR(map.MeanScale(), kUnit, 0.02 * kUnit);
}

TEST(SolveMap, ADriftingOdometryIsStraightened) {
  MapWorld world;
  FurnishRoom(world, 60);
  WorldNoise noise = kNoise;
  noise.scale_drift = 0.1;
  noise.heading_drift_deg = 4;
  const std::vector<MapFrame> frames = world.Frames(noise);
  const Map map = Solve(frames, kExpected, {});
  ExpectTrueMap(map, world, 0.04, 1, 0.04);
  const Map placed = PlaceByOdometry(frames, map, {});
  EXPECT_GT(TrajectoryError(placed.T_world_camera, world), 3 * TrajectoryError(map.T_world_camera, world));
}

// Odometry in UTM coordinates, as of a system with a satellite receiver.
TEST(SolveMap, IsTheSameFarFromTheOrigin) {
  MapWorld world;
  FurnishRoom(world, 40);
  const std::vector<MapFrame> frames = world.Frames(kNoise);
  std::vector<MapFrame> far = frames;
  const Eigen::Vector3d start(5e5, 5.4e6, 200);
  for (MapFrame& frame : far) frame.T_odom_camera.pretranslate(start);
  const Map map = Solve(frames, kExpected, {}), other = Solve(far, kExpected, {});
  EXPECT_NEAR(other.MeanScale() / map.MeanScale(), 1, 1e-6);
  const auto expect_same = [&](const Map& a, const Map& b) {
    ASSERT_EQ(a.objects.size(), b.objects.size());
    const Eigen::Vector3d by = b.MeanScale() * start;
    for (size_t i = 0; i < a.objects.size(); ++i) {
      const Eigen::Vector3d moved = a.objects[i].T_world_object.translation() + by;
      EXPECT_LT((b.objects[i].T_world_object.translation() - moved).norm(), 1e-4) << a.objects[i].id;
    }
    for (size_t i = 0; i < a.T_world_camera.size(); ++i)
      EXPECT_LT((b.T_world_camera[i].translation() - a.T_world_camera[i].translation() - by).norm(), 1e-4);
  };
  expect_same(map, other);
  expect_same(PlaceByOdometry(frames, map, {}), PlaceByOdometry(far, other, {}));
}

// Knots of the scale are as many as frames ask for, not as the time between two sessions.
TEST(SolveMap, OfTwoSessionsAMonthApartIsAsLargeAsOfOne) {
  MapWorld world;
  FurnishRoom(world, 40);
  std::vector<MapFrame> frames = world.Frames(kNoise);
  const Map near = Solve(frames, kExpected, {});
  for (size_t i = frames.size() / 2; i < frames.size(); ++i) frames[i].timestamp += 30 * 24 * 3600.0;
  const Map map = Solve(frames, kExpected, {});
  EXPECT_LT(map.log_scale.size(), near.log_scale.size() + 40);
  ExpectTrueMap(map, world, 0.04, 1, 0.04);
}

TEST(SolveMap, TurningInPlaceGivesMetricObjects) {
  MapWorld world;
  FurnishRoom(world, 0);
  for (int i = 0; i < 40; ++i) world.Look(0, 0, -1.2 + 0.06 * i, 2.5);
  const Map map = Solve(world.Frames({.segment_pixels = 0.5, .unit = kUnit}), ScaleEstimate{}, {});
  ExpectTrueMap(map, world, 0.1, 2, 1e-3);
}

// All the furniture is of another size than its category's; a robot knows better.
TEST(SolveMap, AKnownCameraHeightOutweighsSizes) {
  MapWorld world;
  FurnishRoom(world);
  std::vector<MapFrame> frames = world.Frames(kNoise);
  for (MapFrame& frame : frames) frame.camera_height = {1.15 * world.floor, 0.005};
  const Map map = Solve(frames, kExpected, {});
  EXPECT_NEAR(map.MeanScale(), 1.15 * kUnit, 0.06 * kUnit);
}

// What the front end makes of chairs when it takes their back for their front.
std::vector<MapFrame> WithFlips(MapWorld& world, const std::vector<MapFrame>& frames, size_t every) {
  const std::vector<TrueFurniture> furniture = world.furniture;
  for (TrueFurniture& piece : world.furniture) {
    if (piece.model->spec.name == "chair")
      piece.T_world_object.rotate(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY()));
  }
  const std::vector<MapFrame> flipped = world.Frames(kNoise);
  world.furniture = furniture;
  std::vector<MapFrame> mixed = frames;
  for (size_t i = 0; i < frames.size(); i += every) {
    for (MapObservation& observation : mixed[i].observations) {
      for (const MapObservation& other : flipped[i].observations) {
        if (other.track != observation.track) continue;
        observation.measured = other.measured;
        observation.evidence = other.evidence;
      }
    }
  }
  return mixed;
}

TEST(SolveMap, ChairsSeenTheWrongWayRoundAreOutvoted) {
  MapWorld world;
  FurnishRoom(world);
  const std::vector<MapFrame> frames = WithFlips(world, world.Frames(kNoise), 3);
  ExpectTrueMap(Solve(frames, kExpected, {}), world, 0.03, 1, 0.02);
  MappingOptions unrefined;  // nor do they disturb the single views' consensus
  unrefined.refinement.rounds = 0;
  ExpectTrueMap(Solve(frames, kExpected, unrefined), world, 0.1, 5, 0.1);
}

TEST(SolveMap, SomeFalseMatchesAreSurvived) {
  MapWorld world;
  FurnishRoom(world);
  std::vector<MapFrame> frames = world.Frames(kNoise);
  for (size_t i = 0; i < frames.size(); i += 5) {
    for (MapObservation& observation : frames[i].observations) {
      // Sure of a pose where it is not, and lines of something else.
      observation.measured.T_camera_object.translation() *= 1.4;
      observation.measured.T_camera_object.rotate(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitY()));
      for (Segment& segment : observation.view.segments) segment.p1.y() += 60;
    }
  }
  ExpectTrueMap(Solve(frames, kExpected, {}), world, 0.03, 1, 0.02);
}

// Four views that agree, and one that is just as sure of a place 2 m away: a mean would be off by 0.4 m.
TEST(SolveMapGraph, OneViewFarOffHardlyMatters) {
  MapWorld world;
  world.Put("laptop", 0, 2, 0, 0, 0.8);
  const TrueFurniture& laptop = world.furniture[0];
  MapGraph graph;
  graph.T_world_camera = {Eigen::Isometry3d::Identity()};
  graph.log_scale = {0, 0};
  graph.objects = {{laptop.model, laptop.T_world_object, laptop.coefficients}};
  const Eigen::Index size = 6 + laptop.coefficients.size();
  ObjectFactor factor{0,
                      0,
                      {laptop.T_world_object, laptop.coefficients},
                      50 * Eigen::MatrixXd::Identity(size, size),
                      Eigen::VectorXd::Zero(size)};
  graph.observations.assign(5, factor);
  graph.observations.back().at.T_camera_object.pretranslate(Eigen::Vector3d(2, 0, 0));
  SolveMapGraph(graph, {});
  EXPECT_LT((graph.objects[0].T_world_object.translation() - laptop.T_world_object.translation()).norm(),
            0.05);
}

TEST(SolveMap, FewerThanMinObservationsAreNoObject) {
  MapWorld world;
  FurnishRoom(world);
  std::vector<MapFrame> frames = world.Frames(kNoise);
  for (size_t i = 0; i < frames.size(); ++i) {  // only three of the table
    const size_t kept = i % 12 == 0 && i < 36 ? 3 : 2;
    frames[i].observations.resize(std::min(frames[i].observations.size(), kept));
  }
  MappingOptions options;
  options.recent_seconds = 5;
  const auto tables = [&] {
    const Map map = Solve(frames, kExpected, options);
    return std::count_if(map.objects.begin(), map.objects.end(),
                         [](const MapObject& object) { return object.model->spec.name == "table"; });
  };
  options.min_observations = 3;
  EXPECT_EQ(tables(), 1);
  options.min_observations = 4;
  EXPECT_EQ(tables(), 0);
}

TEST(SolveMap, ObjectsAreNumberedAsTheyAreFirstSeenAndCounted) {
  MapWorld world;
  FurnishRoom(world);
  const std::vector<MapFrame> frames = world.Frames({.unit = kUnit});
  const Map map = Solve(frames, kExpected, {});
  ASSERT_EQ(map.objects.size(), 3u);
  EXPECT_EQ(map.objects[0].id, "chair0");
  EXPECT_EQ(map.objects[1].id, "chair1");
  EXPECT_EQ(map.objects[2].id, "table0");
  ASSERT_EQ(map.phi.size(), frames.size());
  for (size_t i = 0; i < frames.size(); ++i) {
    for (size_t j = 0; j < map.phi[i].size(); ++j) EXPECT_EQ(map.phi[i][j], frames[i].observations[j].track);
  }
}

void ExpectSameBytes(const Map& a, const Map& b) {
  ASSERT_EQ(a.T_world_camera.size(), b.T_world_camera.size());
  for (size_t i = 0; i < a.T_world_camera.size(); ++i)
    EXPECT_EQ(a.T_world_camera[i].matrix(), b.T_world_camera[i].matrix());
  ASSERT_EQ(a.objects.size(), b.objects.size());
  for (size_t o = 0; o < a.objects.size(); ++o) {
    EXPECT_EQ(a.objects[o].T_world_object.matrix(), b.objects[o].T_world_object.matrix());
    EXPECT_EQ(a.objects[o].coefficients, b.objects[o].coefficients);
  }
  EXPECT_EQ(a.phi, b.phi);
  EXPECT_EQ(a.log_scale, b.log_scale);
  EXPECT_EQ(a.scale_sigma, b.scale_sigma);
}

TEST(SolveMap, TheSameFramesGiveTheSameBytes) {
  MapWorld world;
  FurnishRoom(world);
  const std::vector<MapFrame> frames = world.Frames(kNoise);
  ExpectSameBytes(Solve(frames, kExpected, {}), Solve(frames, kExpected, {}));
}

TEST(SolveMap, AScaleThatIsKnownIsHeld) {
  MapWorld world;
  FurnishRoom(world);
  const Map map = Solve(world.Frames({.unit = 1.1}), {1, 0}, {});  // not quite true
  for (const double log_scale : map.log_scale) EXPECT_EQ(log_scale, 0);
  EXPECT_FALSE(map.scale_sigma);
}

TEST(SolveMap, WithoutObjectsItIsTheOdometry) {
  MapWorld world;
  FurnishRoom(world, 10);
  world.furniture.clear();
  const Map map = Solve(world.Frames({.unit = kUnit}), {kUnit, 0.3}, {});
  EXPECT_TRUE(map.objects.empty());
  EXPECT_LT(TrajectoryError(map.T_world_camera, world), 1e-6);
  ASSERT_TRUE(map.scale_sigma);
  EXPECT_NEAR(*map.scale_sigma, 0.3, 1e-6);  // nobody is wiser
}

TEST(SolveMap, OneFrameIsEnough) {
  MapWorld world;
  FurnishRoom(world, 2);
  world.T_world_camera.resize(1);
  const Map map = Solve(world.Frames({.unit = kUnit}), kExpected, {});
  EXPECT_TRUE(map.objects.empty());
  EXPECT_EQ(map.T_world_camera.size(), 1u);
}

// --- Loops

struct Loop {
  double apart = 0.7;    // metres between the chairs of the row
  double turn_deg = 40;  // from chair to chair
  bool alike = false;
};

// Round a circle of 12 m and a little farther, looking outwards at a row of chairs and a few other things.
void FurnishLoop(MapWorld& world, const Loop& loop) {
  const auto around = [](double angle_deg, double radius) {
    const double angle = angle_deg * kDegree;
    return Eigen::Vector2d(radius * std::sin(angle), -1.9 + radius * std::cos(angle));
  };
  for (int chair = 0; chair < 4; ++chair) {
    const double shape = loop.alike ? 0 : 0.5 * chair - 0.5;
    world.Put("chair", (chair - 1.5) * loop.apart, 2.4, 180 + loop.turn_deg * chair, shape);
  }
  int number = 0;
  for (const double angle : {60, 105, 150, 195, 240, 285}) {
    const Eigen::Vector2d at = around(angle, 4.3);
    world.Put(number % 3 == 1 ? "table" : "chair", at.x(), at.y(), 50 * number, 0.3 * (number % 3) - 0.3);
    ++number;
  }
  for (double angle = 0; angle <= 400; angle += 5) {
    const Eigen::Vector2d from = around(angle, 1.9), at = around(angle, 4.3);
    world.Look(from.x(), from.y(), at.x(), at.y());
  }
}

// 5 % of scale and 5 degrees of heading over the loop.
WorldNoise LoopDrift(double scale_sign, double heading_sign) {
  WorldNoise noise = kNoise;
  noise.scale_drift = scale_sign * 0.05 / 12;
  noise.heading_drift_deg = heading_sign * 5.0 / 12;
  return noise;
}

TEST(SolveMap, ALoopIsClosedByItsObjects) {
  MapWorld world;
  FurnishLoop(world, {});
  const std::vector<MapFrame> frames = world.Frames(LoopDrift(1, 1));
  const Map closed = Solve(frames, kExpected, {});
  ExpectTrueMap(closed, world, 0.08, 1, 0.04);
  MappingOptions options;
  options.loop_closure = false;
  const Map open = Solve(frames, kExpected, options);
  EXPECT_GT(open.objects.size(), world.furniture.size());  // what is seen again is there twice
  EXPECT_GT(TrajectoryError(open.T_world_camera, world), 3 * TrajectoryError(closed.T_world_camera, world));
}

class SolveMapLoops : public ::testing::TestWithParam<Loop> {};

// Chairs that look alike, where the drift is half as far as from one to the next.
TEST_P(SolveMapLoops, NoChairIsTakenForItsNeighbour) {
  for (const double sign : {1, -1}) {
    MapWorld world;
    FurnishLoop(world, GetParam());
    ExpectTrueMap(Solve(world.Frames(LoopDrift(sign, sign)), kExpected, {}), world, 0.08, 1.5, 0.04);
  }
}

INSTANTIATE_TEST_SUITE_P(Chairs, SolveMapLoops,
                         ::testing::Values(Loop{0.7, 0, true}, Loop{0.7, 180, true}, Loop{1.2, 0, true}),
                         [](const auto& loop) { return std::to_string(loop.index); });

// --- By odometry alone

TEST(PlaceByOdometry, CamerasAreWhereTheScaledOdometryHasThem) {
  MapWorld world;
  FurnishRoom(world);
  WorldNoise noise = kNoise;
  noise.scale_drift = 0.1;
  noise.heading_drift_deg = 4;
  const std::vector<MapFrame> frames = world.Frames(noise);
  const Map map = Solve(frames, kExpected, {});
  const Map placed = PlaceByOdometry(frames, map, {});
  EXPECT_NEAR(placed.MeanScale(), map.MeanScale(), 1e-9);
  for (size_t i = 0; i < frames.size(); ++i) {
    Eigen::Isometry3d expected = frames[i].T_odom_camera;
    expected.translation() *= map.MeanScale();
    EXPECT_TRUE(placed.T_world_camera[i].isApprox(expected, 1e-9)) << i;
  }
  EXPECT_EQ(placed.phi, map.phi);
  ASSERT_EQ(placed.objects.size(), map.objects.size());
  for (size_t o = 0; o < map.objects.size(); ++o) EXPECT_EQ(placed.objects[o].id, map.objects[o].id);
  EXPECT_GT(ErrorsOf(placed, world).metres, 2 * ErrorsOf(map, world).metres);
}

TEST(PlaceByOdometry, PlacesAnObjectThatOnlyUnsureViewsShow) {
  MapWorld world;
  FurnishRoom(world);
  std::vector<MapFrame> frames = world.Frames({});
  const Map map = Solve(frames, kExpected, {});
  ASSERT_GT(map.objects.size(), 1u);
  for (size_t i = 0; i < frames.size(); ++i) {  // the first object: later ones must not take its place
    for (size_t j = 0; j < map.phi[i].size(); ++j) {
      if (map.phi[i][j] == 0) frames[i].observations[j].track = -1;
    }
  }
  const Map placed = PlaceByOdometry(frames, map, {});
  for (size_t o = 0; o < map.objects.size(); ++o) {
    EXPECT_LT(
        (placed.objects[o].T_world_object.translation() - map.objects[o].T_world_object.translation()).norm(),
        0.05)
        << map.objects[o].id;
  }
}

// --- While frames come in

ObjectMap EmptyMap(const MappingOptions& options) { return {options, BoxOptions{}, ResectionOptions{}}; }

TEST(ObjectMap, HasACameraForEveryFrameAndObjectsAfterTheFirstSolution) {
  MapWorld world;
  FurnishRoom(world, 60);
  ObjectMap map = EmptyMap({});
  const std::vector<MapFrame> frames = world.Frames(kNoise);
  for (size_t i = 0; i < frames.size(); ++i) {
    map.Add(frames[i], kExpected);
    ASSERT_EQ(map.current().T_world_camera.size(), i + 1);
    ASSERT_EQ(map.current().timestamps.size(), i + 1);
    ASSERT_EQ(map.current().phi.size(), i + 1);
    EXPECT_EQ(map.current().phi[i].size(), frames[i].observations.size());
    EXPECT_EQ(map.current().timestamps[i], frames[i].timestamp);
    EXPECT_EQ(map.current().objects.empty(), static_cast<int>(i) + 1 < kFirstSolve) << i;
  }
  ASSERT_EQ(map.current().objects.size(), 3u);
  EXPECT_GT(map.current().objects[0].observations, kFirstSolve);  // it has been solved again since
  EXPECT_LT(TrajectoryError(map.current().T_world_camera, world), 0.1);
}

TEST(ObjectMap, FollowsTheOdometryAtTheExpectedScaleBeforeThat) {
  MapWorld world;
  FurnishRoom(world, 10);
  ObjectMap map = EmptyMap({});
  for (const MapFrame& frame : world.Frames({.unit = kUnit})) map.Add(frame, {kUnit, 0.1});
  EXPECT_LT(TrajectoryError(map.current().T_world_camera, world), 1e-6);
}

TEST(ObjectMap, InTheEndItIsTheMapOfAllFrames) {
  MapWorld world;
  FurnishRoom(world);
  ObjectMap map = EmptyMap({});
  const std::vector<MapFrame> frames = world.Frames(kNoise);
  for (const MapFrame& frame : frames) map.Add(frame, {2, 1});
  ExpectSameBytes(map.Solve(kExpected), Solve(frames, kExpected, {}));
}

TEST(ObjectMap, AScaleThatIsKnownIsHeld) {
  MapWorld world;
  FurnishRoom(world);
  ObjectMap map = EmptyMap({});
  for (const MapFrame& frame : world.Frames({.unit = 1.1})) map.Add(frame, {1, 0});
  EXPECT_EQ(map.current().MeanScale(), 1);
  EXPECT_EQ(map.Solve({1, 0}).MeanScale(), 1);
}

// The frames of a way, to and fro.
std::vector<MapFrame> ToAndFro(const std::vector<MapFrame>& way, size_t count) {
  std::vector<MapFrame> frames;
  for (size_t i = 0; i < count; ++i) {
    const size_t at = i % (2 * way.size() - 2);
    frames.push_back(way[at < way.size() ? at : 2 * way.size() - 2 - at]);
    frames.back().timestamp = 0.2 * static_cast<double>(i);
  }
  return frames;
}

TEST(ObjectMap, ALongVideoOfOneRoomKeepsFewFramesAndTheTrueScale) {
  MapWorld world;
  FurnishRoom(world, 60);
  const std::vector<MapFrame> frames = ToAndFro(world.Frames(kNoise), 2000);
  ObjectMap map = EmptyMap({});
  for (const MapFrame& frame : frames) map.Add(frame, kExpected);
  EXPECT_LT(map.frames().size(), 270u);
  const Map whole = map.WithAllFrames(map.Solve(kExpected));
  ASSERT_EQ(whole.T_world_camera.size(), frames.size());
  ASSERT_EQ(whole.phi.size(), frames.size());
  EXPECT_EQ(whole.objects.size(), 3u);
  EXPECT_NEAR(std::log(whole.MeanScale() / kUnit), 0, 2 * *whole.scale_sigma);
  int observations = 0, explained = 0;
  for (size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(whole.timestamps[i], frames[i].timestamp);
    ASSERT_EQ(whole.phi[i].size(), frames[i].observations.size());
    observations += static_cast<int>(frames[i].observations.size());
    for (const int object : whole.phi[i]) explained += object >= 0 ? 1 : 0;
    const size_t at = i % 118;
    const Eigen::Vector3d truth = world.T_world_camera[at < 60 ? at : 118 - at].translation();
    EXPECT_LT((whole.T_world_camera[i].translation() - truth).norm(), 0.1) << i;
  }
  EXPECT_GT(explained, 0.95 * observations);
}

TEST(ObjectMap, AStepThatIsAJumpDoesNotTieCameras) {
  MapWorld world;
  FurnishRoom(world);
  std::vector<MapFrame> frames = world.Frames(kNoise);
  for (size_t i = 20; i < frames.size(); ++i)
    frames[i].T_odom_camera.pretranslate(Eigen::Vector3d(0.1, 0, 0.05));
  const Map bent = Solve(frames, kExpected, {});
  frames[20].follows_jump = true;
  const Map map = Solve(frames, kExpected, {});
  ExpectTrueMap(map, world, 0.05, 1, 0.05);
  EXPECT_GT(TrajectoryError(bent.T_world_camera, world), TrajectoryError(map.T_world_camera, world));
}

TEST(ObjectMap, FramesSinceAChangeOfUnitAreBroughtBack) {
  MapWorld world;
  FurnishRoom(world, 20);
  const std::vector<MapFrame> frames = world.Frames({});
  const UnitChange change{frames[9].timestamp, frames[9].T_odom_camera.translation(), 2};
  ObjectMap map = EmptyMap({});
  for (size_t i = 0; i < frames.size(); ++i) {
    MapFrame frame = frames[i];
    if (i > 9) frame.T_odom_camera.translation() += frame.T_odom_camera.translation() - change.from;
    map.Add(frame, {1, 0.1});
  }
  map.Undo(change);
  for (size_t i = 0; i < frames.size(); ++i)
    EXPECT_TRUE(map.frames()[i].T_odom_camera.isApprox(frames[i].T_odom_camera, 1e-12)) << i;
}

}  // namespace
}  // namespace armature
