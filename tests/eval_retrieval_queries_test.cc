// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "eval/retrieval/retrieval_queries.h"
#include "geometry/random.h"
#include "support/known_frames.h"

namespace armature {
namespace {

using testing::FrameLibrary;

// Two frames that two cameras saw; of the first camera detection 0 is of the second frame.
class SeenFrames : public ::testing::Test {
 protected:
  SeenFrames() {
    map_.timestamps = {0, 0.2};
    map_.T_world_camera.resize(2, Eigen::Isometry3d::Identity());
    for (const char* id : {"frame0", "frame1"}) {
      map_.objects.emplace_back();
      map_.objects.back().id = id;
      map_.objects.back().model = &model_;
      map_.objects.back().coefficients = Eigen::Vector2d(1, 2);
    }
    map_.objects[1].T_world_object.translation().z() = 40;  // far from where it is
    map_.phi = {{1}, {0, 1}};
    Observe(0, 0, "frame1", 1);
    Observe(0.2, 0, "frame0", 0);
    Observe(0.2, 1, "frame1", 1);
    truth_.objects = {{.id = "a", .category = "frame", .instance = "cad:1"},
                      {.id = "b", .category = "frame", .instance = "cad:2", .size = {1, 2, 3}}};
    for (const size_t camera : {0, 1}) {
      views_[camera].resize(map_.phi[camera].size());
      for (ObjectView& view : views_[camera]) {
        view.camera = &camera_;
        view.model = &model_;
      }
    }
  }

  void Observe(double timestamp, int index, const std::string& object, size_t of) {
    const std::pair key(std::llround(1e6 * timestamp), index);
    RunObservation& observation = run_.observations[key];
    observation.timestamp = timestamp;
    observation.index = index;
    observation.object = object;
    truth_.detections[key] = of;
  }

  CategoryModel model_ = testing::TwoModeFrames();
  Camera camera_{640, 480, 500, 500, 319.5, 239.5, {}};
  Map map_;
  RunResults run_;
  GroundTruth truth_;
  ViewsOfCameras views_;
};

TEST_F(SeenFrames, AreAskedForWhereverTheyStand) {
  const ObjectPairs pairs = PairsBySight(map_, run_, truth_);
  EXPECT_EQ(PickCameras(map_, pairs, 24), (std::vector<size_t>{0, 1}));
  EXPECT_EQ(PickCameras(map_, {{0, 0}}, 24), (std::vector<size_t>{1}));
  const std::vector<RetrievalQuery> queries = MakeMapQueries(map_, pairs, truth_, views_, 24);
  ASSERT_EQ(queries.size(), 2u);
  EXPECT_EQ(queries[1].object, "frame1");
  EXPECT_EQ(queries[1].category, "frame");
  EXPECT_EQ(queries[1].true_model, "cad:2");
  EXPECT_EQ(queries[1].true_size, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(queries[1].shape.coefficients, Eigen::Vector2d(1, 2));
  EXPECT_EQ(queries[1].shape.size, map_.objects[1].Size());
  EXPECT_EQ(queries[1].sightings->frames.size(), 2u);
  EXPECT_EQ(queries[1].sightings->T_world_object.translation().z(), 40);
  EXPECT_EQ(queries[0].sightings->frames.size(), 1u);
}

TEST_F(SeenFrames, OfUnknownModelsAreNoQueries) {
  truth_.objects[0].instance = "";
  const std::vector<RetrievalQuery> queries =
      MakeMapQueries(map_, PairsBySight(map_, run_, truth_), truth_, views_, 24);
  ASSERT_EQ(queries.size(), 1u);
  EXPECT_EQ(queries[0].object, "frame1");
}

TEST(QueriesOfALibrary, AreEveryNthInstanceWithNoise) {
  const FrameLibrary frames(7);
  const std::vector<RetrievalQuery> queries = MakeLibraryQueries(frames.frames(), 3, 0.1, 5);
  ASSERT_EQ(queries.size(), 3u);
  EXPECT_EQ(queries[1].true_model, "cad:3");
  EXPECT_EQ(queries[1].true_size, Eigen::Vector3d(2, 2, 2));
  EXPECT_FALSE(queries[1].shape.evidence || queries[1].sightings);
  EXPECT_NE(queries[1].shape.coefficients, Eigen::Vector2d(3, 0));
  EXPECT_NEAR((queries[1].shape.coefficients - Eigen::Vector2d(3, 0)).norm(), 0, 0.6);
  EXPECT_EQ(MakeLibraryQueries(frames.frames(), 3, 0.1, 5)[2].shape.coefficients,
            queries[2].shape.coefficients);
  EXPECT_NE(MakeLibraryQueries(frames.frames(), 3, 0.1, 6)[2].shape.coefficients,
            queries[2].shape.coefficients);
}

TEST(SeededNumbers, AreNormal) {
  Random random(1);
  double sum = 0, squares = 0;
  for (int i = 0; i < 20000; ++i) {
    const double value = random.Normal(0, 1);
    sum += value;
    squares += value * value;
  }
  EXPECT_NEAR(sum / 20000, 0, 0.02);
  EXPECT_NEAR(squares / 20000, 1, 0.03);
}

}  // namespace
}  // namespace armature
