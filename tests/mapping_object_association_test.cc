// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "geometry/rotation.h"
#include "mapping/map_objects.h"
#include "mapping/map_solver.h"
#include "mapping/object_association.h"
#include "support/map_world.h"

namespace armature {
namespace {

using testing::MapWorld;
using testing::WorldNoise;

// A frame a second in which these tracks are seen.
std::vector<MapFrame> FramesOfTracks(const std::vector<std::vector<int>>& tracks) {
  std::vector<MapFrame> frames;
  for (size_t i = 0; i < tracks.size(); ++i) {
    frames.emplace_back();
    frames.back().timestamp = 50 + static_cast<double>(i);
    for (const int track : tracks[i]) {
      frames.back().observations.emplace_back();
      frames.back().observations.back().track = track;
    }
  }
  return frames;
}

TEST(BreakTracks, OneObjectATrackInTheOrderOfFirstSight) {
  const auto phi = BreakTracks(FramesOfTracks({{7}, {3, 7}, {7, 3}}), 3, 1);
  EXPECT_EQ(phi, (ObjectOfObservation{{0}, {1, 0}, {0, 1}}));
}

TEST(BreakTracks, ALongAbsenceBreaksATrackAndAShortOneDoesNot) {
  const auto phi = BreakTracks(FramesOfTracks({{5}, {}, {}, {5}, {}, {}, {}, {5}, {5}}), 3, 1);
  EXPECT_EQ(phi, (ObjectOfObservation{{0}, {}, {}, {0}, {}, {}, {}, {1}, {1}}));
}

TEST(BreakTracks, ShortPiecesAndUnsureDetectionsAreOfNoObject) {
  const auto phi = BreakTracks(FramesOfTracks({{1, 2, -1}, {2, -1}, {2, -1}, {1}}), 3, 3);
  EXPECT_EQ(phi, (ObjectOfObservation{{-1, 0, -1}, {0, -1}, {0, -1}, {-1}}));
}

// --- Joining

// A camera that goes to the left by 1.2 m and looks at what is 2.5 m ahead.
void Walk(MapWorld& world, int cameras = 16) {
  for (int i = 0; i < cameras; ++i) world.Look(-1.2 * i / (cameras - 1.0), 0, 0, 2.5);
}

// From the frame on, what the other world has in store, as new tracks.
std::vector<MapFrame> Spliced(std::vector<MapFrame> frames, const std::vector<MapFrame>& others,
                              size_t from) {
  for (size_t i = from; i < frames.size(); ++i) {
    frames[i].observations = others[i].observations;
    for (MapObservation& observation : frames[i].observations) observation.track += 100;
  }
  return frames;
}

// As from here on the odometry had drifted, and the time was later.
void Drift(const Eigen::Isometry3d& drift, double later, size_t from, std::vector<MapFrame>& frames) {
  for (size_t i = from; i < frames.size(); ++i) {
    frames[i].T_odom_camera = drift * frames[i].T_odom_camera;
    frames[i].timestamp += later;
  }
}

struct FirstMap {
  MapGraph graph;
  ObjectOfObservation phi;

  explicit FirstMap(const std::vector<MapFrame>& frames) {
    graph = MakeOdometryGraph(frames, {1, 0}, StepNoise{});
    phi = BreakTracks(frames, 3, 4);
    AddObjects(frames, phi, graph);
  }
};

const WorldNoise kTrackNoise{.segment_pixels = 0.5, .depth = 0.04, .yaw_deg = 3, .shape = 0.3};

TEST(FindMerges, TwoPiecesOfOneObjectBecomeOne) {
  MapWorld world;
  world.Put("chair", 0, 2.5, 150);
  Walk(world);
  const std::vector<MapFrame> frames = world.Frames(kTrackNoise);
  const std::vector<MapFrame> pieces = Spliced(frames, frames, 6);
  FirstMap map(pieces);
  ASSERT_EQ(map.graph.objects.size(), 2u);
  const std::vector<Merge> merges = FindMerges(map.graph, pieces, std::nullopt, {});
  ASSERT_EQ(merges.size(), 1u);
  EXPECT_EQ(merges[0].kept, 1);  // of 10 views
  EXPECT_EQ(merges[0].joined, 0);
  EXPECT_FALSE(merges[0].flipped);
  EXPECT_EQ(merges[0].turn, 0);
  ApplyMerge(merges[0], map.graph, map.phi);
  EXPECT_EQ(map.graph.objects.size(), 1u);
  EXPECT_EQ(map.graph.observations.size(), 16u);
  for (const ObjectFactor& factor : map.graph.observations) EXPECT_EQ(factor.object, 0);
  EXPECT_EQ(map.phi, ObjectOfObservation(16, {0}));
  EXPECT_TRUE(FindMerges(map.graph, pieces, std::nullopt, {}).empty());
}

TEST(FindMerges, ObjectsBehindAJoinedOneMoveUp) {
  MapWorld world;
  world.Put("chair", -0.7, 2.5, 150);
  world.Put("table", 1.0, 3.0, 20);
  Walk(world);
  std::vector<MapFrame> frames = world.Frames(kTrackNoise);
  for (size_t i = 6; i < frames.size(); ++i) frames[i].observations[0].track += 100;  // of the chair
  FirstMap map(frames);
  ASSERT_EQ(map.graph.objects.size(), 3u);
  const CategoryModel* table = map.graph.objects[1].model;
  const std::vector<Merge> merges = FindMerges(map.graph, frames, std::nullopt, {});
  ASSERT_EQ(merges.size(), 1u);
  ApplyMerge(merges[0], map.graph, map.phi);
  ASSERT_EQ(map.graph.objects.size(), 2u);
  for (size_t i = 0; i < frames.size(); ++i) {
    for (size_t j = 0; j < frames[i].observations.size(); ++j) {
      const GraphObject& object = map.graph.objects.at(static_cast<size_t>(map.phi[i][j]));
      EXPECT_EQ(object.model, frames[i].observations[j].view.model);
    }
  }
  EXPECT_EQ(map.graph.objects[0].model, table);
}

// The same room, but the object is seen turned by the angle from the 7th frame on.
std::vector<MapFrame> TurnedHalfway(MapWorld& world, const char* category, double angle = M_PI) {
  world.Put(category, 0, 2.5, 150);
  Walk(world);
  const std::vector<MapFrame> frames = world.Frames(kTrackNoise);
  world.furniture[0].T_world_object.rotate(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()));
  return Spliced(frames, world.Frames(kTrackNoise), 6);
}

// Joins the two pieces and solves the graph; hands back the cost.
double CostOfJoining(const std::vector<MapFrame>& frames, double turn) {
  FirstMap map(frames);
  EXPECT_EQ(map.graph.objects.size(), 2u);
  const std::vector<Merge> merges = FindMerges(map.graph, frames, std::nullopt, {});
  EXPECT_EQ(merges.size(), 1u);
  EXPECT_FALSE(merges[0].flipped);
  EXPECT_NEAR(std::abs(merges[0].turn), turn, 0.1);
  ApplyMerge(merges[0], map.graph, map.phi);
  return SolveMapGraph(map.graph, {}).final_cost;
}

TEST(FindMerges, ATableTurnedByHalfATurnIsTheSameTable) {
  MapWorld straight, turned;
  const double cost = CostOfJoining(TurnedHalfway(straight, "table", 0), 0);
  EXPECT_NEAR(CostOfJoining(TurnedHalfway(turned, "table"), M_PI), cost, 0.05 * cost);
}

TEST(FindMerges, AChairSeenTheWrongWayRoundIsJoinedWithoutItsTurn) {
  MapWorld world;
  const std::vector<MapFrame> frames = TurnedHalfway(world, "chair");
  FirstMap map(frames);
  ASSERT_EQ(map.graph.objects.size(), 2u);
  const std::vector<Merge> merges = FindMerges(map.graph, frames, std::nullopt, {});
  ASSERT_EQ(merges.size(), 1u);
  EXPECT_TRUE(merges[0].flipped);
  ApplyMerge(merges[0], map.graph, map.phi);
  int without_rotation = 0;
  for (const ObjectFactor& factor : map.graph.observations) {
    without_rotation += factor.A.leftCols<3>().norm() < 1e-2 * factor.A.norm() ? 1 : 0;
  }
  EXPECT_EQ(without_rotation, 6);  // those of the smaller piece
}

TEST(FindMerges, NeighboursThatAreNeverSeenTogetherStayTwo) {
  MapWorld world, other;
  world.Put("chair", -0.35, 2.5, 150);
  other.Put("chair", 0.35, 2.5, 150);
  Walk(world);
  Walk(other);
  const std::vector<MapFrame> frames = Spliced(world.Frames(kTrackNoise), other.Frames(kTrackNoise), 8);
  FirstMap map(frames);
  map.graph.objects[1].model = map.graph.objects[0].model;  // each world has models of its own
  ASSERT_EQ(map.graph.objects.size(), 2u);
  EXPECT_TRUE(FindMerges(map.graph, frames, std::nullopt, {}).empty());
}

TEST(FindMerges, WhatIsSeenTogetherIsNotOne) {
  MapWorld world;
  world.Put("chair", 0, 2.5, 150);
  Walk(world);
  const std::vector<MapFrame> frames = world.Frames(kTrackNoise);
  for (const int together : {2, 3}) {
    std::vector<MapFrame> doubled = Spliced(frames, frames, 8);
    for (int i = 0; i < together; ++i) {
      MapObservation early = frames[static_cast<size_t>(8 + i)].observations[0];
      doubled[static_cast<size_t>(8 + i)].observations.push_back(early);
    }
    const FirstMap map(doubled);
    ASSERT_EQ(map.graph.objects.size(), 2u);
    EXPECT_EQ(FindMerges(map.graph, doubled, std::nullopt, {}).empty(), together > 2) << together;
  }
}

TEST(FindMerges, DifferentCategoriesAreNeverOne) {
  MapWorld world;
  world.Put("chair", 0, 2.5, 150);
  Walk(world);
  const std::vector<MapFrame> chairs = world.Frames(kTrackNoise);
  world.furniture.clear();
  world.Put("table", 0, 2.5, 150);
  const std::vector<MapFrame> frames = Spliced(chairs, world.Frames(kTrackNoise), 8);
  const FirstMap map(frames);
  ASSERT_EQ(map.graph.objects.size(), 2u);
  EXPECT_TRUE(FindMerges(map.graph, frames, std::nullopt, {}).empty());
}

Eigen::Isometry3d Shift(double x, double yaw_deg) {
  Eigen::Isometry3d drift = Eigen::Isometry3d::Identity();
  drift.linear() = ExpSO3({0, yaw_deg * kDegree, 0});
  drift.translation().x() = x;
  return drift;
}

// Chairs in a row that are seen, then nothing for these metres of the way, then they are seen again.
std::vector<MapFrame> SeenAgain(const MapWorld& world, const Eigen::Isometry3d& drift, double metres = 10) {
  const std::vector<MapFrame> frames = world.Frames(kTrackNoise);
  std::vector<MapFrame> again = frames;
  for (int i = 0; i < 20; ++i) {  // there and back
    again.emplace_back();
    again.back().timestamp = frames.back().timestamp + 0.2 * (i + 1);
    again.back().T_odom_camera = frames.back().T_odom_camera;
    again.back().T_odom_camera.translation().z() -= metres * (i < 10 ? i : 20 - i) / 20;
  }
  const size_t from = again.size();
  again.insert(again.end(), frames.begin(), frames.end());
  Drift(drift, 10, from, again);
  return again;
}

TEST(FindMerges, WhatIsSeenAgainAfterALoopIsJoinedUnlessOnlyRecentObjectsAre) {
  MapWorld world;
  world.Put("chair", 0, 2.5, 150);
  Walk(world);
  const std::vector<MapFrame> frames = SeenAgain(world, Shift(0.4, 4));
  const FirstMap map(frames);
  ASSERT_EQ(map.graph.objects.size(), 2u);
  EXPECT_EQ(FindMerges(map.graph, frames, std::nullopt, {}).size(), 1u);
  EXPECT_TRUE(FindMerges(map.graph, frames, 3.0, {}).empty());
}

TEST(FindMerges, MoreThanTheOdometryCanHaveDriftedIsAnotherObject) {
  MapWorld world;
  world.Put("chair", 0, 2.5, 150);
  Walk(world);
  const std::vector<MapFrame> frames = SeenAgain(world, Shift(4, 0), 1);
  const FirstMap map(frames);
  ASSERT_EQ(map.graph.objects.size(), 2u);
  EXPECT_TRUE(FindMerges(map.graph, frames, std::nullopt, {}).empty());
}

TEST(FindMerges, AChairThatMayBeEitherOfTwoComesWithItsRivals) {
  MapWorld world;
  world.Put("chair", -0.35, 2.5, 150);
  world.Put("chair", 0.35, 2.5, 150);
  Walk(world);
  const std::vector<MapFrame> frames = SeenAgain(world, Shift(0.35, 0));
  const FirstMap map(frames);
  ASSERT_EQ(map.graph.objects.size(), 4u);
  EXPECT_GT(FindMerges(map.graph, frames, std::nullopt, {}).size(), 1u);
}

TEST(FindMerges, WhatHasNoRivalsComesFirst) {
  MapWorld world;
  world.Put("chair", -0.35, 2.5, 150);
  world.Put("chair", 0.35, 2.5, 150);
  world.Put("table", 0, 3.6, 20);
  Walk(world);
  const std::vector<MapFrame> frames = SeenAgain(world, Shift(0.35, 0));
  const FirstMap map(frames);
  ASSERT_EQ(map.graph.objects.size(), 6u);
  const std::vector<Merge> merges = FindMerges(map.graph, frames, std::nullopt, {});
  ASSERT_EQ(merges.size(), 1u);
  EXPECT_EQ(map.graph.objects[static_cast<size_t>(merges[0].kept)].model->spec.name, "table");
}

TEST(FindMerges, AChairThatWouldHaveToBeFlippedIsNoRival) {
  MapWorld world;
  world.Put("chair", -0.35, 2.5, 150);
  world.Put("chair", 0.35, 2.5, -30);
  Walk(world);
  const std::vector<MapFrame> frames = SeenAgain(world, Shift(0.35, 0));
  const FirstMap map(frames);
  ASSERT_EQ(map.graph.objects.size(), 4u);
  const std::vector<Merge> merges = FindMerges(map.graph, frames, std::nullopt, {});
  ASSERT_EQ(merges.size(), 1u);
  EXPECT_FALSE(merges[0].flipped);
}

TEST(DropUnseen, LaterObjectsMoveUp) {
  MapWorld world;
  world.Put("chair", -0.6, 2.5, 150);
  world.Put("chair", 0.6, 2.5, 150);
  world.Put("table", 0, 4, 0);
  Walk(world);
  const std::vector<MapFrame> frames = world.Frames(kTrackNoise);
  FirstMap map(frames);
  ASSERT_EQ(map.graph.objects.size(), 3u);
  std::erase_if(map.graph.observations, [](const ObjectFactor& factor) { return factor.object == 1; });
  DropUnseen(map.graph, map.phi);
  ASSERT_EQ(map.graph.objects.size(), 2u);
  EXPECT_EQ(map.graph.objects[1].model->spec.name, "table");
  EXPECT_EQ(map.phi[0], (std::vector<int>{0, -1, 1}));
  for (const ObjectFactor& factor : map.graph.observations) EXPECT_LT(factor.object, 2);
}

// --- Detections

class AssociateFrameTest : public ::testing::Test {
 protected:
  AssociateFrameTest() {
    world_.Put("chair", -0.6, 2.5, 150);
    world_.Put("chair", 0.6, 2.5, 150);
    Walk(world_);
    frames_ = world_.Frames({});
  }

  ObjectOfObservation Associate(std::optional<double> seconds_between = {}) const {
    const FirstMap map(frames_);
    return Associate(map, changed_.empty() ? frames_ : changed_, seconds_between);
  }

  static ObjectOfObservation Associate(const FirstMap& map, const std::vector<MapFrame>& frames,
                                       std::optional<double> seconds_between) {
    const std::vector<TimeSpan> spans = SeenSpans(map.graph.objects.size(), frames, map.phi);
    ObjectOfObservation phi;
    for (size_t i = 0; i < frames.size(); ++i) {
      phi.push_back(AssociateFrame(map.graph.objects, spans, WithoutEvidence(frames[i]),
                                   map.graph.T_world_camera[i], seconds_between));
    }
    return phi;
  }

  MapWorld world_;
  std::vector<MapFrame> frames_;   // of which the objects are made
  std::vector<MapFrame> changed_;  // whose detections are associated, if not the same
};

TEST_F(AssociateFrameTest, EachToItsOwn) { EXPECT_EQ(Associate(), ObjectOfObservation(16, {0, 1})); }

TEST_F(AssociateFrameTest, DoNotNeedATrack) {
  for (MapObservation& observation : frames_[3].observations) observation.track = -1;
  EXPECT_EQ(Associate()[3], (std::vector<int>{0, 1}));
}

TEST_F(AssociateFrameTest, FollowTheBoxNotTheTrack) {
  changed_ = frames_;
  std::swap(changed_[3].observations[0].view.detection.box, changed_[3].observations[1].view.detection.box);
  EXPECT_EQ(Associate()[3], (std::vector<int>{1, 0}));
}

TEST_F(AssociateFrameTest, OneToOne) {
  changed_ = frames_;
  MapObservation second = frames_[3].observations[0];  // another box on the first chair, not quite on it
  second.view.detection.box.x += 0.2 * second.view.detection.box.width;
  changed_[3].observations.insert(changed_[3].observations.begin(), second);
  EXPECT_EQ(Associate()[3], (std::vector<int>{-1, 0, 1}));
}

TEST_F(AssociateFrameTest, ABoxWithoutAnObjectIsOfNone) {
  changed_ = frames_;
  changed_[3].observations[0].view.detection.box.y -= 250;
  EXPECT_EQ(Associate()[3], (std::vector<int>{-1, 1}));
}

TEST_F(AssociateFrameTest, APartOfTheObjectIsTheObject) {
  changed_ = frames_;
  Box& box = changed_[3].observations[0].view.detection.box;
  box.height *= 0.25;  // its lower part is hidden
  EXPECT_EQ(Associate()[3], (std::vector<int>{0, 1}));
}

TEST_F(AssociateFrameTest, AnotherCategoryIsAnotherObject) {
  changed_ = frames_;
  changed_[3].observations[0].view.model = &world_.Model("table");
  EXPECT_EQ(Associate()[3], (std::vector<int>{-1, 1}));
}

TEST_F(AssociateFrameTest, OnlyRecentObjectsWithoutLoopClosure) {
  changed_ = frames_;
  for (size_t i = 6; i < changed_.size(); ++i) changed_[i].timestamp += 20;
  for (size_t i = 6; i < frames_.size(); ++i) frames_[i].observations.clear();  // no longer seen there
  FirstMap map(frames_);
  map.phi.assign(16, {-1, -1});
  for (size_t i = 0; i < 6; ++i) map.phi[i] = {0, 1};
  EXPECT_EQ(Associate(map, changed_, std::nullopt)[10], (std::vector<int>{0, 1}));
  EXPECT_EQ(Associate(map, changed_, 3.0)[10], (std::vector<int>{-1, -1}));
}

}  // namespace
}  // namespace armature
