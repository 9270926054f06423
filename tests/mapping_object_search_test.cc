// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mapping/estimate_over_views.h"
#include "mapping/object_evidence.h"
#include "mapping/object_search.h"
#include "support/map_world.h"

namespace armature {
namespace {

using testing::FurnishRoom;
using testing::MapWorld;

constexpr double kUnit = 2.65;  // metres a unit of odometry

std::vector<MapFrame> WithoutTracks(std::vector<MapFrame> frames) {
  for (MapFrame& frame : frames) {
    for (MapObservation& observation : frame.observations) observation.track = -1;
  }
  return frames;
}

double NearestTruth(const ObjectCandidate& found, const MapWorld& world) {
  double nearest = 1e9;
  for (const auto& truth : world.furniture) {
    if (truth.model != found.object.model) continue;
    const Eigen::Vector3d apart =
        truth.T_world_object.translation() - found.object.T_world_object.translation();
    nearest = std::min(nearest, apart.norm());
  }
  return nearest;
}

TEST(SearchObjects, FindsEachOnceWithAllItsViewsAndWithoutTracks) {
  MapWorld world;
  FurnishRoom(world, 30);
  const auto found = SearchObjects(WithoutTracks(world.Frames({.depth = 0.05})), world.T_world_camera, {});
  ASSERT_EQ(found.size(), 3u);
  for (const ObjectCandidate& candidate : found) {
    EXPECT_LT(NearestTruth(candidate, world), 0.3);
    EXPECT_GT(candidate.views.size(), 20u);
  }
  EXPECT_GE(found[0].support, found[1].support);
}

TEST(SearchObjects, SingleViewsThatAreAllTooNearDoNotMatter) {
  MapWorld world;
  FurnishRoom(world, 30);
  std::vector<MapFrame> frames = world.Frames({});
  for (MapFrame& frame : frames) {
    for (MapObservation& observation : frame.observations)
      observation.measured.T_camera_object.translation() *= 0.85;
  }
  for (const ObjectCandidate& candidate : SearchObjects(frames, world.T_world_camera, {})) {
    EXPECT_LT(NearestTruth(candidate, world), 0.25);
  }
}

TEST(SearchObjects, AFewDetectionsAreNoObject) {
  MapWorld world;
  FurnishRoom(world, 3);
  EXPECT_TRUE(SearchObjects(world.Frames({}), world.T_world_camera, {}).empty());
}

TEST(SearchObjects, NothingToFindInFramesWithoutDetections) {
  MapWorld world;
  FurnishRoom(world, 30);
  world.furniture.clear();
  EXPECT_TRUE(SearchObjects(world.Frames({}), world.T_world_camera, {}).empty());
}

TEST(BreakAtGaps, WhatComesBackLateIsAnother) {
  std::vector<MapFrame> frames(12);
  for (size_t i = 0; i < frames.size(); ++i) frames[i].timestamp = static_cast<double>(i) + (i < 6 ? 0 : 60);
  ObjectCandidate candidate;
  for (size_t i = 0; i < 11; ++i) candidate.views.emplace_back(i, 0);
  const auto pieces = BreakAtGaps(frames, {candidate}, 3, 4);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].views.size(), 6u);
  EXPECT_EQ(pieces[1].views.size(), 5u);
  EXPECT_EQ(BreakAtGaps(frames, {candidate}, 3, 6).size(), 1u);
  EXPECT_EQ(BreakAtGaps(frames, {candidate}, 100, 4).size(), 1u);
}

class SearchScaleFromAnyStart : public ::testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(TimesTheTruth, SearchScaleFromAnyStart, ::testing::Values(1e-3, 0.3, 1.0, 40.0));

TEST_P(SearchScaleFromAnyStart, IsNearTheTruth) {
  MapWorld world;
  FurnishRoom(world, 30);
  const auto frames = WithoutTracks(world.Frames({.depth = 0.05, .unit = kUnit}));
  const ScaleEstimate scale = SearchScale(frames, {GetParam() * kUnit, 0.5}, 4);
  EXPECT_NEAR(std::log(scale.scale / kUnit), 0, 0.15);
}

TEST(SearchScale, WhatIsKnownStays) {
  MapWorld world;
  FurnishRoom(world, 30);
  const ScaleEstimate scale = SearchScale(world.Frames({}), {1, 0}, 4);
  EXPECT_EQ(scale.scale, 1);
  EXPECT_EQ(scale.sigma, 0);
}

TEST(SearchScale, ACameraThatStandsTellsNothing) {
  MapWorld world;
  FurnishRoom(world, 30);
  for (Eigen::Isometry3d& pose : world.T_world_camera) pose.translation().setZero();
  EXPECT_EQ(SearchScale(world.Frames({}), {2, 0.5}, 4).scale, 2);
}

// The true map with one object displaced, and its views.
struct Displaced {
  MapWorld world;
  std::vector<MapFrame> frames;
  MapGraph graph;
  std::vector<SeenObjects> seen;
  std::vector<std::pair<size_t, size_t>> views;

  explicit Displaced(const Eigen::Isometry3d& by) {
    FurnishRoom(world, 30);
    frames = world.Frames({});
    graph.T_world_camera = world.T_world_camera;
    graph.up_world = {0, -1, 0};
    for (const auto& truth : world.furniture)
      graph.objects.push_back({truth.model, truth.T_world_object, truth.coefficients});
    graph.objects[0].T_world_object = graph.objects[0].T_world_object * by;
    for (size_t i = 0; i < frames.size(); ++i) {
      seen.push_back(SeeObjects(graph, i, world.camera));
      for (size_t j = 0; j < frames[i].observations.size(); ++j) {
        if (frames[i].observations[j].track == 0) views.emplace_back(i, j);
      }
    }
  }
  GraphObject Estimate() const {
    const BoxOptions box;
    const ResectionOptions resection;
    return EstimateOverViews({frames, graph, seen, box, resection}, 0, views);
  }
};

Eigen::Isometry3d Step(double yaw_deg, double x, double z) {
  Eigen::Isometry3d step = Eigen::Isometry3d::Identity();
  step.linear() = ExpSO3({0, yaw_deg * kDegree, 0});
  step.translation() << x, 0, z;
  return step;
}

TEST(EstimateOverViews, BringsAMisplacedAndTurnedObjectBack) {
  for (const Eigen::Isometry3d& by : {Step(0, 0.2, -0.15), Step(90, 0, 0), Step(180, 0.1, 0.2)}) {
    const Displaced map(by);
    const GraphObject estimated = map.Estimate();
    const auto& truth = map.world.furniture[0];
    EXPECT_LT((estimated.T_world_object.translation() - truth.T_world_object.translation()).norm(), 0.03);
    const Eigen::AngleAxisd turned(truth.T_world_object.linear().transpose() *
                                   estimated.T_world_object.linear());
    EXPECT_LT(turned.angle(), 3 * kDegree);
  }
}

TEST(ComputeProbability, ATrueObjectIsLikelyAndOneBesideItIsNot) {
  const BoxOptions box;
  const auto probability = [&](const Displaced& map) {
    ObjectOfObservation phi;
    for (const MapFrame& frame : map.frames) phi.emplace_back(frame.observations.size(), -1);
    for (const auto& [i, j] : map.views) phi[i][j] = 0;
    return ComputeProbability(CollectEvidence(map.frames, phi, map.graph, box)[0]);
  };
  EXPECT_GT(probability(Displaced(Step(0, 0, 0))), 0.9);
  EXPECT_LT(probability(Displaced(Step(60, 0.7, -0.5))), 0.5);
}

TEST(ComputeProbability, GrowsWithWhatLinesExplainAndFallsWithAnOddSize) {
  ObjectEvidence evidence{10, 0.7, 0.5, 0.1, 0.06, 0.2, 0.0, 0.5};
  const double as_is = ComputeProbability(evidence);
  evidence.coverage = 0.8;
  EXPECT_GT(ComputeProbability(evidence), as_is);
  evidence.coverage = 0.5;
  evidence.log_size = -0.25;
  EXPECT_LT(ComputeProbability(evidence), as_is);
}

}  // namespace
}  // namespace armature
