// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "geometry/rotation.h"
#include "retrieval/sightings.h"
#include "support/map_world.h"

namespace armature {
namespace {

using testing::MapWorld;

// Two objects in turns: camera i has object 0 as its first detection, object 1 as its second where i is even,
// and one that is of no object between them.
Map InTurns(size_t cameras) {
  Map map;
  for (size_t i = 0; i < cameras; ++i) {
    map.phi.push_back(i % 2 == 0 ? std::vector<int>{0, -1, 1} : std::vector<int>{0, -1});
    map.timestamps.push_back(10 + static_cast<double>(i));
    map.T_world_camera.emplace_back(Eigen::Translation3d(static_cast<double>(i), 0, 0));
  }
  return map;
}

std::vector<size_t> PickCameras(const std::vector<Sighting>& sightings) {
  std::vector<size_t> cameras(sightings.size());
  for (size_t i = 0; i < cameras.size(); ++i) cameras[i] = sightings[i].camera;
  return cameras;
}

TEST(SightingsToLookAt, AllOfOneObjectWhereTheyAreFew) {
  const std::vector<Sighting> sightings = SightingsToLookAt(InTurns(6), 1, 3);
  EXPECT_EQ(PickCameras(sightings), (std::vector<size_t>{0, 2, 4}));
  for (const Sighting& sighting : sightings) EXPECT_EQ(sighting.detection, 2);
}

TEST(SightingsToLookAt, SpreadEvenlyWhereTheyAreMany) {
  EXPECT_EQ(PickCameras(SightingsToLookAt(InTurns(100), 0, 4)), (std::vector<size_t>{12, 37, 62, 87}));
  EXPECT_EQ(PickCameras(SightingsToLookAt(InTurns(100), 1, 2)), (std::vector<size_t>{24, 74}));
  EXPECT_EQ(PickCameras(SightingsToLookAt(InTurns(5), 0, 4)), (std::vector<size_t>{0, 1, 3, 4}));
  EXPECT_EQ(PickCameras(SightingsToLookAt(InTurns(7), 0, 1)), (std::vector<size_t>{3}));
}

TEST(SightingsToLookAt, NoneOfAnObjectThatWasNotSeen) {
  EXPECT_TRUE(SightingsToLookAt(InTurns(6), 2, 3).empty());
  EXPECT_TRUE(SightingsToLookAt(InTurns(6), 0, 0).empty());
}

// A table in front of a chair.
class SightedRoom : public ::testing::Test {
 protected:
  SightedRoom() {
    world_.Put("chair", 0, 3, 0);
    world_.Put("table", 0, 2, 0);
    for (int i = 0; i < 3; ++i) world_.Look(0.2 * i, 0, 0, 2.5);
    map_.T_world_camera = world_.T_world_camera;
    for (const testing::TrueFurniture& piece : world_.furniture) {
      MapObject object;
      object.model = piece.model;
      object.T_world_object = piece.T_world_object;
      object.coefficients = piece.coefficients;
      map_.objects.push_back(object);
    }
    for (size_t i = 0; i < 3; ++i) {
      map_.timestamps.push_back(5.5 + static_cast<double>(i));
      map_.phi.push_back({1, 0});
      for (const double x : {10.0, 20.0}) {
        ObjectView view;
        view.camera = &world_.camera;
        view.detection.box = {x, static_cast<double>(i), 50, 60};
        view.occluders.resize(17);  // of another time
        views_[i].push_back(view);
      }
    }
  }

  MapWorld world_;
  Map map_;
  ViewsOfCameras views_;
};

TEST_F(SightedRoom, HasTheViewsOfTheSightings) {
  const ObjectSightings seen = LookAt(map_, 0, {{0, 1}, {2, 1}}, views_, {0, 0, 1});
  ASSERT_EQ(seen.frames.size(), 2);
  EXPECT_EQ(seen.up_world, Eigen::Vector3d(0, 0, 1));
  EXPECT_TRUE(seen.T_world_object.isApprox(map_.objects[0].T_world_object));
  for (const auto& [frame, camera] : {std::pair(0, 0), std::pair(1, 2)}) {
    const auto f = static_cast<size_t>(frame), c = static_cast<size_t>(camera);
    EXPECT_TRUE(seen.T_world_camera[f].isApprox(map_.T_world_camera[c]));
    EXPECT_EQ(seen.frames[f].timestamp, map_.timestamps[c]);
    ASSERT_EQ(seen.frames[f].observations.size(), 1);
    const Box& box = seen.frames[f].observations[0].view.detection.box;
    EXPECT_EQ(box.x, 20);
    EXPECT_EQ(box.y, camera);
  }
}

TEST_F(SightedRoom, TheOtherObjectsHideIt) {
  const ObjectSightings seen = LookAt(map_, 0, {{1, 1}}, views_, {0, -1, 0});
  const std::vector<ImageFace>& occluders = seen.frames[0].observations[0].view.occluders;
  const MapObject& table = map_.objects[1];
  const std::vector<ImageFace> expected = ProjectFaces(
      world_.camera, table.model->spec, WireframeFromCoefficients(*table.model, table.coefficients),
      map_.T_world_camera[1].inverse() * table.T_world_object);
  ASSERT_EQ(occluders.size(), expected.size());
  ASSERT_FALSE(expected.empty());
  EXPECT_EQ(occluders[0].corners, expected[0].corners);
  // The table's top hides what is behind its middle, and not what is before it.
  const Eigen::Vector3d middle =
      map_.T_world_camera[1].inverse() * table.T_world_object *
      WireframeFromCoefficients(*table.model, table.coefficients).midpoints.leftCols<4>().rowwise().mean();
  EXPECT_TRUE(occluders[0].Hides(world_.camera.Project(middle), 0.8 / middle.z()));
  EXPECT_FALSE(occluders[0].Hides(world_.camera.Project(middle), 1.2 / middle.z()));
}

TEST_F(SightedRoom, AloneNothingHidesIt) {
  map_.objects.pop_back();
  const ObjectSightings seen = LookAt(map_, 0, {{1, 1}}, views_, {0, -1, 0});
  EXPECT_TRUE(seen.frames[0].observations[0].view.occluders.empty());
}

TEST(EstimateUp, IsTheMeanOfTheObjectsYAxes) {
  Map map;
  EXPECT_EQ(EstimateUp(map), Eigen::Vector3d(0, -1, 0)) << "the camera's, where there is no object";
  map.objects.resize(2);
  map.objects[0].T_world_object.linear() = ExpSO3({0.1, 0, 0}) * Eigen::Vector3d(-1, -1, 1).asDiagonal();
  map.objects[1].T_world_object.linear() = ExpSO3({-0.1, 0, 0}) * Eigen::Vector3d(1, -1, -1).asDiagonal();
  EXPECT_TRUE(EstimateUp(map).isApprox(Eigen::Vector3d(0, -1, 0)));
}

}  // namespace
}  // namespace armature
