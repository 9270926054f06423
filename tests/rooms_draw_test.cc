// SPDX-License-Identifier: BSD-3-Clause
// Rooms from recipes.
#include <gtest/gtest.h>

#include <set>

#include "base/text.h"
#include "datasets/cad/folder_collection.h"
#include "datasets/cad/lid.h"
#include "datasets/rooms/draw_room.h"
#include "datasets/rooms/generate_rooms.h"
#include "datasets/rooms/room_text.h"
#include "datasets/scene/distractors.h"
#include "datasets/scene/scene_yaml.h"
#include "support/expect_input_error.h"
#include "support/published_chairs.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::ExpectInputError;
using testing::TempFolder;

constexpr const char* kRoom =
    "name: den\nframes: 12\nfps: 3\nroom: {width: [4.5, 5], depth: [4.5, 5]}\n"
    "layout:\n  - {group: dining, count: 1, chairs: [2, 4]}\n  - {group: desk, count: 1, laptops: 1}\n";

Recipe Written(const TempFolder& folder, const std::string& text) {
  return ReadRecipe(folder.Write("den.yaml", text));
}

const Furniture& OwnFurniture() {
  static const Furniture furniture{DrawCollection({}), FurnitureSpecs()};
  return furniture;
}

std::string TextOf(const Recipe& recipe, std::uint64_t seed, int number) {
  return RoomText(DrawRoom(recipe, OwnFurniture(), {seed, number, "room"}));
}

TEST(DrawRoom, IsTheSameWhateverElseIsDrawn) {
  const TempFolder folder;
  const Recipe recipe = Written(folder, kRoom);
  const std::string alone = TextOf(recipe, 1, 2);
  EXPECT_NE(TextOf(recipe, 1, 0), alone);
  EXPECT_EQ(TextOf(recipe, 1, 2), alone);
  EXPECT_NE(TextOf(recipe, 2, 2), alone);
  const auto many = WriteRooms(recipe, OwnFurniture(), {.first = 0, .count = 3}, folder / "many");
  const auto one = WriteRooms(recipe, OwnFurniture(), {.first = 2, .count = 1}, folder / "one");
  ASSERT_EQ(many.size(), 3U);
  EXPECT_EQ(many[2].scene.filename(), "den-development-002.yaml");
  EXPECT_EQ(ReadTextFile(many[2].scene), ReadTextFile(one[0].scene));
}

TEST(DrawRoom, IsASceneOfWhatItSays) {
  const TempFolder folder;
  const Recipe recipe = Written(folder, std::string(kRoom) + "distractors: {count: 2}\n");
  for (int number = 0; number < 4; ++number) {
    const DrawnRoom room = DrawRoom(recipe, OwnFurniture(), {5, number, "room"});
    const Scene scene = ReadScene(folder.Write("room.yaml", RoomText(room)), OwnFurniture().collection);
    ASSERT_EQ(scene.objects.size(), room.scene.objects.size());
    EXPECT_GE(scene.objects.size(), 3U);
    for (size_t i = 0; i < scene.objects.size(); ++i) {
      EXPECT_EQ(scene.objects[i].instance.id, room.scene.objects[i].instance.id);
      EXPECT_TRUE(scene.objects[i].instance.held_out);
      EXPECT_TRUE(scene.objects[i].T_world_object.isApprox(room.scene.objects[i].T_world_object, 1e-9));
    }
    EXPECT_EQ(Distractors(scene).size(), Distractors(room.scene).size());
    EXPECT_EQ(scene.room.size, room.scene.room.size);
    const auto poses = CameraPoses(scene.path, 12, 3), drawn = CameraPoses(room.scene.path, 12, 3);
    for (size_t i = 0; i < poses.size(); ++i) EXPECT_TRUE(poses[i].isApprox(drawn[i], 1e-9));
  }
}

TEST(DrawRoom, GivesEveryKindOfPath) {
  const TempFolder folder;
  for (const char* kind : {"loop", "turn", "arc", "corridor", "handheld", "close"}) {
    const Recipe recipe =
        Written(folder, std::string(kRoom) + "path: {kind: " + kind + ", height: [1, 1.5], pauses: 1}\n");
    const DrawnRoom room = DrawRoom(recipe, OwnFurniture(), {1, 0, "room"});
    const auto kind_of = room.scene.path.kind;
    EXPECT_EQ(kind_of == CameraPath::Kind::kLoop, std::string(kind) == "loop");
    EXPECT_EQ(kind_of == CameraPath::Kind::kTurn, std::string(kind) == "turn");
    if (kind_of == CameraPath::Kind::kKeyframes) {
      EXPECT_GE(room.scene.path.keyframes.size(), 4U);
    }
  }
}

// Of a collection on disk: the seat is as high as drawn, whatever the unit of the file.
TEST(InDrawnSize, GivesSeatsTopsAndLaptopsTheirMeasure) {
  const TempFolder folder;
  testing::WritePublishedChairs(folder, {testing::PublishedId(true)});
  const Furniture furniture{CollectFurniture(DrawCollection({}), {folder.path()}), FurnitureSpecs()};
  FurnitureRecipe sizes;
  sizes.seat_height = Constant(0.48), sizes.chair_size = Constant(0.9);
  sizes.table_height = Constant(1.05), sizes.laptop_width = Constant(0.31);
  Random random(3);
  std::set<std::string> collections;
  for (int i = 0; i < 12; ++i) {
    const CadInstance chair =
        InDrawnSize(furniture, DrawInstance(furniture, "chair", {0.8, 0.9}, random), sizes, random);
    collections.insert(chair.collection);
    EXPECT_NEAR(MeasureOf(furniture, chair), 0.48, 1e-4);
    if (chair.collection == "keypointnet") {
      EXPECT_NEAR(chair.size.x(), 0.45, 1e-4);
    }
    EXPECT_TRUE(chair.held_out);
  }
  EXPECT_EQ(collections, (std::set<std::string>{"armature", "keypointnet"}));
  const CadInstance table =
      InDrawnSize(furniture, DrawInstance(furniture, "table", {3, 3}, random), sizes, random);
  EXPECT_NEAR(MeasureOf(furniture, table), 1.05, 1e-4);
  const CadInstance laptop =
      InDrawnSize(furniture, DrawInstance(furniture, "laptop", {1, 1}, random), sizes, random);
  EXPECT_NEAR(MeasureOf(furniture, laptop), 0.31, 1e-4);
  EXPECT_GE(*laptop.lid_deg, 85);
  EXPECT_LE(*laptop.lid_deg, 130);
  EXPECT_NEAR(LidAngle(laptop.wireframe), *laptop.lid_deg, 0.1);
}

TEST(FurnitureRecipe, HasCoffeeAndHighTables) {
  Random random(1);
  const FurnitureRecipe sizes;
  int coffee = 0, high = 0;
  for (int i = 0; i < 2000; ++i) {
    const double height = DrawNumber(sizes.table_height, random);
    coffee += height < 0.6 ? 1 : 0;
    high += height > 0.9 ? 1 : 0;
  }
  EXPECT_NEAR(coffee, 200, 60);
  EXPECT_NEAR(high, 100, 45);
}

TEST(WriteRooms, NamesSplits) {
  Recipe recipe;
  recipe.name = "den";
  EXPECT_EQ(RoomName(recipe, {.seed = kDevelopmentSeed}, 7), "den-development-007");
  EXPECT_EQ(RoomName(recipe, {.seed = kCheckSeed}, 1234), "den-check-1234");
  EXPECT_EQ(RoomName(recipe, {.seed = 42}, 0), "den-42-000");
}

TEST(WriteRooms, LeavesNothingOfRoomsThatCannotBeDrawn) {
  const TempFolder folder;
  const Recipe crowded =
      Written(folder, "name: den\nroom: {width: 2, depth: 2}\nlayout:\n  - {group: meeting}\n");
  ExpectInputError([&] { WriteRooms(crowded, OwnFurniture(), {.count = 1}, folder / "out"); },
                   {"den.yaml", "room 0 of seed 1", "20 tries", "allow larger rooms"});
  EXPECT_TRUE(std::filesystem::is_empty(folder / "out"));
}

class BadRecipe : public ::testing::Test {
 protected:
  void ExpectError(const std::string& more, int line, std::vector<std::string> texts) {
    texts.push_back(fmt::format("den.yaml:{}:", line));
    ExpectInputError([&] { Written(folder_, "name: den\n" + more); }, texts);
  }
  TempFolder folder_;
};

TEST_F(BadRecipe, IsReportedWithItsLine) {
  ExpectError("frames: 3\n", 1, {"layout", "missing"});
  ExpectError("layout: []\nwals: 3\n", 3, {"wals"});
  ExpectError("layout:\n  - {group: dinning}\n", 3, {"dinning", "dining"});
  ExpectError("layout:\n  - {group: free, chairs: 3}\n", 3, {"chairs"});
  ExpectError("layout:\n  - {count: 3}\n", 3, {"group", "missing"});
  ExpectError("layout: []\nroom: {width: [1, 5]}\n", 3, {"room.width", "[2, 50]"});
  ExpectError("layout: []\nroom: {floor: lava}\n", 3, {"lava"});
  ExpectError("layout: []\ncamera: {size: 640}\n", 3, {"camera.size", "WIDTHxHEIGHT"});
  ExpectError("layout: []\ncamera: {size: [1, 2]}\n", 3, {"camera.size"});
  ExpectError("layout: []\ndistractors: {shape: sofas}\n", 3, {"sofas", "sofa"});
  ExpectError("layout: []\npath: {kind: {choice: [loop, lop]}}\n", 3, {"lop", "loop"});
  ExpectError("mixture: [{recipe: no.yaml}]\n", 2, {"no.yaml", "no file"});
  ExpectError("mixture: [{recipe: den.yaml}]\n", 2, {"mixture itself"});
  ExpectError("mixture: []\n", 2, {"mixture"});
  ExpectError("mixture: []\nframes: 3\n", 3, {"frames"});
}

// What scenes would not allow is found in the recipe, not in a scene file that is never kept.
TEST_F(BadRecipe, IsReportedWithTheLineOfASectionOfScenes) {
  ExpectError("layout: []\neffects:\n  noise: 2\n  bluur_px: 1\n", 5, {"bluur_px", "blur_px"});
  ExpectError("layout: []\neffects: {noise: 2,\n  blur_px: [-3, -1]}\n", 4, {"blur_px", "-"});
  ExpectError("layout: []\nodometry:\n  scale: 1\n  lost: {share: [0, 0.1], secnds: 1}\n", 5,
              {"secnds", "seconds"});
  ExpectError("layout: []\n\ndetections: {setting: {choice: [simulated, netwrk]}}\n", 4, {"netwrk"});
  ExpectError("layout: []\ndetections: {table: {missed: {normal: [3, 0.1]}}}\n", 3, {"missed"});
}

TEST(DrawRoom, DrawsTheValuesOfSectionsInSections) {
  const TempFolder folder;
  const Recipe recipe =
      Written(folder, std::string(kRoom) +
                          "odometry:\n  lost: {share: [0.05, 0.1], seconds: {choice: [2]}}\n"
                          "detections: {setting: network, table: {spanning: [0.3, 0.4]}}\n");
  const Scene scene = ReadScene(folder.Write("room.yaml", TextOf(recipe, 1, 0)), OwnFurniture().collection);
  EXPECT_GE(scene.odometry.lost_share, 0.05);
  EXPECT_LE(scene.odometry.lost_share, 0.1);
  EXPECT_EQ(scene.odometry.lost_seconds, 2);
  const Scene other = ReadScene(folder.Write("room.yaml", TextOf(recipe, 1, 1)), OwnFurniture().collection);
  EXPECT_NE(other.odometry.lost_share, scene.odometry.lost_share);
}

TEST(ShippedRecipes, AreSound) {
  for (const char* name : {"loops", "handheld", "meeting", "close", "turn", "mixed"}) {
    const Recipe recipe = ReadRecipe(std::filesystem::path(ARMATURE_SOURCE_DIR) / "configs/rooms" /
                                     (std::string(name) + ".yaml"));
    EXPECT_EQ(recipe.name, name);
    const TempFolder folder;
    EXPECT_EQ(WriteRooms(recipe, OwnFurniture(), {.count = 1}, folder / "out").size(), 1U);
  }
}

}  // namespace
}  // namespace armature
