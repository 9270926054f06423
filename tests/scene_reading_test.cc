// SPDX-License-Identifier: BSD-3-Clause
// Scene files: what they say, and what is wrong with them.
#include <gtest/gtest.h>

#include "datasets/scene/scene_yaml.h"
#include "support/block_collection.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using Eigen::Vector3d;
using testing::ExpectInputError;

constexpr const char* kTable =
    "  - {id: desk, category: table, instance: table-0001, position: [1, 2], yaw_deg: 90}\n";

class SceneTest : public ::testing::Test {
 protected:
  Scene Read(const std::string& yaml) {
    return ReadScene(folder_.Write("scene.yaml", "name: test\n" + yaml), collection_);
  }
  Scene ReadObjects(const std::string& items) { return Read("objects:\n" + items); }

  // `line`: of the text after the name's, which is line 1.
  void ExpectError(const std::string& yaml, int line, std::vector<std::string> texts) {
    texts.push_back(fmt::format("scene.yaml:{}:", line + 1));
    ExpectInputError([&] { Read(yaml); }, texts);
  }
  // The first item is line 1.
  void ExpectObjectError(const std::string& items, int line, const std::vector<std::string>& texts) {
    ExpectError("objects:\n" + items, line + 1, texts);
  }

  std::vector<CadInstance> collection_ = testing::BlockCollection();
  testing::TempFolder folder_;
};

TEST_F(SceneTest, HasDefaultsForAllButTheName) {
  const Scene scene = Read("");
  EXPECT_EQ(scene.name, "test");
  EXPECT_EQ(scene.frames, 150);
  EXPECT_EQ(scene.camera.width, 856);
  EXPECT_EQ(scene.camera.cx, 427.5);
  EXPECT_EQ(scene.lamps.size(), 2u);
  EXPECT_TRUE(scene.objects.empty());
  EXPECT_EQ(scene.path.kind, CameraPath::Kind::kLoop);
}

TEST_F(SceneTest, DrawsHaveOtherSeedsAndNames) {
  const auto file = folder_.Write("scene.yaml", "name: test\nseed: 7\n");
  EXPECT_EQ(ReadScene(file, collection_, 1).seed, 7u);
  EXPECT_EQ(ReadScene(file, collection_, 1).name, "test");
  EXPECT_EQ(ReadScene(file, collection_, 3).name, "test-draw3");
  EXPECT_NE(ReadScene(file, collection_, 2).seed, ReadScene(file, collection_, 3).seed);
}

TEST_F(SceneTest, ReadsEverySection) {
  const Scene scene = Read(
      "about: a room\nseed: 7\nfps: 20\nframes: 30\n"
      "camera: {width: 640, height: 480, fx: 500, fy: 510, cx: 300, cy: 200}\n"
      "room: {size: [5, 4, 3], floor: {texture: tiles, colour: [0.1, 0.2, 0.3], second: [0, 0, 1], scale: "
      "0.4, "
      "gloss: 0.5}, skirting: 0, pictures: 2, clutter: 1, table_clutter: 4}\n"
      "lamps:\n  - {position: [1, 0, 2.9], size: [0.5, 0.6], colour: [1, 0.9, 0.8], power: 2}\n"
      "path: {kind: turn, centre: [0.1, 0.2], height: 1.5, pitch_deg: 10, overlap: 0.5, start_deg: 30, "
      "clockwise: true, sway_deg: 0}\n"
      "effects: {blur_px: 0.1, motion_blur_px: 0.2, noise: 3, exposure_change: 0.04, vignetting: 0.05}\n"
      "odometry: {scale: 2, scale_drift: 0.1, heading_drift_deg: 5, translation_noise: 0.02, "
      "rotation_noise_deg: 0.3}\n"
      "detections: {box: 0.01, missed: 0.02, false_alarms: 0.03, min_visible: 0.5, min_size_px: 10, "
      "azimuth_deg: 1, elevation_deg: 2, tilt_deg: 3, turned: 0.05}\n");
  EXPECT_EQ(scene.about, "a room");
  EXPECT_EQ(scene.seed, 7u);
  EXPECT_EQ(scene.fps, 20);
  EXPECT_EQ(scene.frames, 30);
  EXPECT_EQ(scene.camera.fy, 510);
  EXPECT_EQ(scene.camera.cx, 300);
  EXPECT_EQ(scene.room.size, Vector3d(5, 4, 3));
  EXPECT_EQ(scene.room.floor.texture, Texture::kTiles);
  EXPECT_EQ(scene.room.floor.second, Colour(0, 0, 1));
  EXPECT_EQ(scene.room.floor.gloss, 0.5);
  EXPECT_EQ(scene.room.skirting, 0);
  EXPECT_EQ(scene.room.table_clutter, 4);
  ASSERT_EQ(scene.lamps.size(), 1u);
  EXPECT_EQ(scene.lamps[0].size.y(), 0.6);
  EXPECT_EQ(scene.lamps[0].power, 2);
  EXPECT_EQ(scene.path.kind, CameraPath::Kind::kTurn);
  EXPECT_EQ(scene.path.centre.y(), 0.2);
  EXPECT_TRUE(scene.path.clockwise);
  EXPECT_EQ(scene.effects.vignetting, 0.05);
  EXPECT_EQ(scene.odometry.rotation_noise_deg, 0.3);
  EXPECT_EQ(scene.detections.any.turned, 0.05);
}

TEST_F(SceneTest, StandsObjectsOnTheFloorAndTurnsThem) {
  const Scene scene = ReadObjects(
      "  - {id: a, category: chair, instance: chair-0001, position: [1, 0]}\n"
      "  - {id: b, category: chair, instance: chair-0001, position: [-1, 0], yaw_deg: 90}\n");
  ASSERT_EQ(scene.objects.size(), 2u);
  const Eigen::Isometry3d& a = scene.objects[0].T_world_object;
  EXPECT_TRUE(a.translation().isApprox(Vector3d(1, 0, 0.45)));
  EXPECT_TRUE((a.linear() * Vector3d::UnitZ()).isApprox(-Vector3d::UnitY()));  // the front
  EXPECT_TRUE((a.linear() * Vector3d::UnitY()).isApprox(Vector3d::UnitZ()));
  EXPECT_TRUE((scene.objects[1].T_world_object.linear() * Vector3d::UnitZ()).isApprox(Vector3d::UnitX()));
}

// The table's top is 0.74 m high; turned by 90 degrees its x is the world's y and its z the world's x.
TEST_F(SceneTest, StandsObjectsOnTablesInTheirFrame) {
  const Scene scene = ReadObjects(std::string(kTable) +
                                  "  - {id: pc, category: laptop, instance: laptop-0001, on: desk, position: "
                                  "[0.3, 0.1], yaw_deg: -90}\n");
  const Eigen::Isometry3d& laptop = scene.objects[1].T_world_object;
  EXPECT_TRUE(laptop.translation().isApprox(Vector3d(1.1, 2.3, 0.74 + 0.115)));
  EXPECT_TRUE((laptop.linear() * Vector3d::UnitZ()).isApprox(-Vector3d::UnitY(), 1e-12));
}

TEST_F(SceneTest, GivesObjectsOtherSizes) {
  const Scene scene = ReadObjects(
      "  - {id: a, category: chair, instance: chair-0001, position: [1, 0], scale: 1.1}\n"
      "  - {id: b, category: chair, instance: chair-0001, position: [-1, 0], size: [0.5, 1, 0.6]}\n");
  EXPECT_TRUE(scene.objects[0].instance.size.isApprox(1.1 * Vector3d(0.46, 0.9, 0.52)));
  EXPECT_NEAR(scene.objects[0].T_world_object.translation().z(), 0.495, 1e-9);
  EXPECT_TRUE(scene.objects[1].instance.size.isApprox(Vector3d(0.5, 1, 0.6)));
  EXPECT_TRUE(BoundingBox(scene.objects[1].instance.mesh).sizes().isApprox(Vector3d(0.5, 1, 0.6)));
  ExpectObjectError("  - {id: a, category: chair, position: [1, 0], scale: 1.1, size: [1, 1, 1]}\n", 1,
                    {"objects[0].scale", "leave one out"});
}

TEST_F(SceneTest, FindsInstancesOfAnyCollection) {
  CadInstance other = testing::BlockChair("seat-7", {0.4, 0.8, 0.4});
  other.collection = "published", other.held_out = true;
  collection_.push_back(other);
  const auto chosen = [&](const std::string& keys) {
    return ReadObjects("  - {id: a, category: chair, position: [1, 2]" + keys + "}\n").objects[0].instance.id;
  };
  EXPECT_EQ(chosen(", instance: seat-7"), "seat-7");
  EXPECT_EQ(chosen(", collection: published"), "seat-7");
  EXPECT_EQ(chosen(", collection: armature"), "chair-0010");
  EXPECT_EQ(chosen(""), "chair-0010");  // others are only sampled where they are named
  ExpectObjectError("  - {id: a, category: chair, collection: publishd, position: [1, 2]}\n", 1,
                    {"publishd", "published", "--collection"});
}

TEST_F(SceneTest, SamplesAmongTheHeldOut) {
  for (int seed = 0; seed < 5; ++seed) {
    const Scene scene = Read(fmt::format(
        "seed: {}\nobjects:\n  - {{id: a, category: chair, instance: sampled, position: [1, 2]}}\n", seed));
    EXPECT_EQ(scene.objects[0].instance.id, "chair-0010");
  }
}

TEST_F(SceneTest, SamplesBySeedAndPlaceInTheList) {
  for (int i = 2; i < 40; ++i) {
    collection_.push_back(testing::BlockChair(fmt::format("chair-{:03}0", i), {0.4, 0.9, 0.4}));
  }
  const auto drawn = [&](int seed) {
    const Scene scene =
        Read(fmt::format("seed: {}\nobjects:\n"
                         "  - {{id: a, category: chair, position: [-1, 2]}}\n"
                         "  - {{id: b, category: chair, position: [1, 2]}}\n",
                         seed));
    return std::pair(scene.objects[0].instance.id, scene.objects[1].instance.id);
  };
  EXPECT_EQ(drawn(1), drawn(1));
  EXPECT_NE(drawn(1), drawn(2));
  EXPECT_NE(drawn(1).first, drawn(1).second);
}

TEST_F(SceneTest, SamplesNoneTwiceWhileThereAreOthers) {
  collection_.push_back(testing::BlockChair("chair-0020", {0.4, 0.9, 0.4}));
  for (int seed = 0; seed < 8; ++seed) {
    const Scene scene =
        Read(fmt::format("seed: {}\nobjects:\n"
                         "  - {{id: a, category: chair, position: [-1, 2]}}\n"
                         "  - {{id: b, category: chair, position: [1, 2]}}\n"
                         "  - {{id: c, category: chair, position: [2, 2]}}\n",
                         seed));
    EXPECT_NE(scene.objects[0].instance.id, scene.objects[1].instance.id);
  }
}

TEST_F(SceneTest, SamplesNothingLargerThanAskedFor) {
  collection_.push_back(testing::BlockTable("table-0020", {0.8, 0.74, 0.7}));
  for (int seed = 0; seed < 8; ++seed) {
    const Scene scene = Read(fmt::format(
        "seed: {}\nobjects:\n  - {{id: a, category: table, at_most: [1.0, 0.7], position: [0, 2]}}\n", seed));
    EXPECT_EQ(scene.objects[0].instance.id, "table-0020");
  }
  ExpectObjectError("  - {id: a, category: table, at_most: [0.5, 0.5], position: [0, 2]}\n", 1,
                    {"at_most", "no held-out table"});
  ExpectObjectError("  - {id: a, category: table, instance: table-0001, at_most: [2, 2], position: [0, 2]}\n",
                    1, {"at_most", "leave one out"});
}

// Its seat fits below the table's top, though the boxes around the two overlap.
TEST_F(SceneTest, LetsAChairBeDrawnUpToATable) {
  const std::string chair = "  - {id: seat, category: chair, instance: chair-0001, yaw_deg: 180, ";
  EXPECT_NO_THROW(ReadObjects("  - {id: desk, category: table, instance: table-0001, position: [0, -2]}\n" +
                              chair + "position: [0, -2.3]}\n"));
  ExpectObjectError("  - {id: desk, category: table, instance: table-0001, position: [0, -2]}\n" + chair +
                        "position: [0.45, -2.3]}\n",
                    2, {"objects[1].position", "seat overlap desk"});
}

TEST_F(SceneTest, NamesUnknownKeysWithTheNearest) {
  ExpectError("sed: 1\n", 1, {"'sed'", "'seed'"});
  ExpectError("room: {floors: {}}\n", 1, {"'floors'", "'floor'"});
  ExpectError("path:\n  kind: turn\n  length: 3\n", 3, {"'length'"});
  ExpectObjectError("  - {id: a, category: chair, positon: [0, 0]}\n", 1, {"'positon'", "'position'"});
}

TEST_F(SceneTest, ReportsBadNamesAndKinds) {
  ExpectInputError([&] { ReadScene(folder_.Write("scene.yaml", "name: a/b\n"), collection_); },
                   {"scene.yaml:1", "'a/b'", "letters"});
  ExpectObjectError("  - {id: 'a,b', category: chair, position: [0, 2]}\n", 1, {"objects[0].id", "letters"});
  ExpectError("path: {kind: lop}\n", 1, {"'lop'", "'loop'"});
  ExpectError("room:\n  floor: {texture: boardz}\n", 2, {"'boardz'", "'boards'"});
  ExpectError("clutter:\n  - {shape: bok, size: [1, 1, 1], position: [0, 0]}\n", 2, {"'bok'", "'box'"});
}

TEST_F(SceneTest, ReportsSizesThatAreNotPositive) {
  ExpectError("room: {size: [8, 0, 2.7]}\n", 1, {"room.size", "greater than 0"});
  ExpectError("lamps:\n  - {position: [0, 0, 2], size: [1, -1]}\n", 2, {"lamps[0].size", "greater than 0"});
  ExpectError("clutter:\n  - {shape: box, size: [1, 1, 0], position: [0, 0]}\n", 2, {"clutter[0].size"});
  ExpectError("frames: 0\n", 1, {"frames 0 < 1"});
  ExpectError("camera: {fx: -1}\n", 1, {"fx -1 < 1"});
  ExpectError("path: {length: 1, width: 2}\n", 1, {"path.width", "length 1"});
}

TEST_F(SceneTest, ReportsBadLists) {
  ExpectError("room: {size: [8, 2.7]}\n", 1, {"room.size", "2 values", "3"});
  ExpectError("objects: chair\n", 1, {"objects", "list"});
  ExpectError("objects:\n  - chair\n", 2, {"objects[0]", "map"});
  ExpectError("lamps: []\n", 1, {"lamps", "empty"});
  ExpectError("room: {walls: {colour: [1, 2, 0]}}\n", 1, {"room.walls.colour", "0..1"});
  ExpectError("path: {kind: keyframes, keyframes: [{position: [0, 0]}]}\n", 1, {"path.keyframes", "two"});
}

TEST_F(SceneTest, ReportsInstancesThatAreNotThere) {
  ExpectObjectError("  - {id: a, category: chiar, position: [0, 2]}\n", 1, {"'chiar'", "'chair'"});
  ExpectObjectError("  - {id: a, category: chair, instance: chair-0011, position: [0, 2]}\n", 1,
                    {"'chair-0011'", "'chair-0001'"});
  ExpectObjectError("  - {id: a, category: chair, instance: table-0001, position: [0, 2]}\n", 1,
                    {"objects[0].instance", "'table-0001', a table"});
}

TEST_F(SceneTest, ReportsObjectsInEachOthersWay) {
  ExpectObjectError(std::string(kTable) + "  - {id: desk, category: chair, position: [0, 2]}\n", 2,
                    {"objects[1].id", "'desk'", "twice"});
  ExpectObjectError(
      "  - {id: a, category: chair, position: [0, 2]}\n"
      "  - {id: b, category: chair, position: [0.3, 2.2]}\n",
      2, {"objects[1].position", "b overlap a"});
  ExpectError(
      "objects:\n  - {id: a, category: chair, position: [0, 2]}\n"
      "clutter:\n  - {shape: box, size: [0.3, 0.3, 0.3], position: [0.1, 2]}\n",
      4, {"clutter[0].position", "overlap a"});
}

TEST_F(SceneTest, ReportsWhatIsOutsideOfTheRoom) {
  ExpectObjectError("  - {id: a, category: chair, position: [3.9, 2]}\n", 1,
                    {"objects[0].position", "out of the room of 8 x 6"});
  ExpectError("lamps:\n  - {position: [3.8, 0, 2.5]}\n", 2, {"lamps[0].position", "outside of the room"});
  ExpectError("clutter:\n  - {shape: box, size: [0.3, 0.3, 2.8], position: [2, 2]}\n", 2,
              {"out of the room"});
}

TEST_F(SceneTest, ReportsWhatCannotStandWhereItShould) {
  const std::string laptop = "  - {id: pc, category: laptop, instance: laptop-0001, ";
  ExpectObjectError(kTable + laptop + "on: dask, position: [0, 0]}\n", 2, {"'dask'", "'desk'"});
  ExpectObjectError(kTable + laptop + "on: desk, position: [0.6, 0]}\n", 2,
                    {"objects[1].position", "edge of desk", "1.30 x 0.75"});
  ExpectObjectError(
      "  - {id: seat, category: chair, position: [0, 2]}\n" + laptop + "on: seat, position: [0, 0]}\n", 2,
      {"objects[1].on", "a chair", "only tables"});
}

TEST_F(SceneTest, ReportsACameraInTheWay) {
  ExpectError("path: {kind: turn, centre: [5, 0]}\n", 1, {"path", "frame 0", "outside of the room"});
  ExpectError("path: {kind: turn, height: 2.65}\n", 1, {"frame 0", "ceiling"});
  ExpectError(
      "objects:\n  - {id: a, category: chair, position: [2, 0]}\nframes: 5\n"
      "path: {kind: keyframes, height: 0.8, sway: 0, keyframes: [{position: [0, 0]}, "
      "{position: [4, 0]}]}\nroom: {size: [10, 6, 3]}\n",
      4, {"path", "frame 2", "[2.00, 0.00, 0.80]", "a;"});
  ExpectError(
      "clutter:\n  - {shape: box, size: [0.3, 0.3, 1], position: [0, 0]}\n"
      "path: {kind: turn, height: 1.05}\n",
      3, {"path", "clutter[0]"});
}

// With the least and the greatest furniture that may be sampled for them.
TEST(ShippedScenes, AreSound) {
  std::vector<CadInstance> large{testing::BlockChair("chair-0010", {0.6, 1.15, 0.6}),
                                 testing::BlockTable("table-0010", {1.4, 0.76, 0.85}),
                                 testing::BlockLaptop("laptop-0010", {0.4, 0.27, 0.36})};
  std::vector<CadInstance> small{testing::BlockChair("chair-0010", {0.38, 0.7, 0.4}),
                                 testing::BlockTable("table-0010", {0.72, 0.71, 0.68}),
                                 testing::BlockLaptop("laptop-0010", {0.29, 0.18, 0.24})};
  for (const auto& collection : {large, small}) {
    for (const auto& [name, objects] : {std::pair("seq1", 7), {"seq2", 12}, {"seq3", 9}, {"sample", 5}}) {
      const auto file =
          std::filesystem::path(ARMATURE_SOURCE_DIR) / "datasets/scenes" / (std::string(name) + ".yaml");
      const Scene scene = ReadScene(file, collection);
      EXPECT_EQ(scene.name, name);
      EXPECT_EQ(scene.objects.size(), static_cast<size_t>(objects)) << name;
    }
  }
}

}  // namespace
}  // namespace armature
