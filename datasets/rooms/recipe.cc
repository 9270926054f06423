// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/rooms/recipe.h"

#include <fmt/format.h>

#include <numeric>
#include <regex>

#include "base/enum_names.h"
#include "base/errors.h"
#include "base/text.h"
#include "datasets/scene/distractors.h"
#include "datasets/scene/scene_fields.h"
#include "datasets/scene/scene_sections.h"

namespace armature {

template <>
struct EnumNames<GroupRecipe::Kind> {
  static constexpr NamedValue<GroupRecipe::Kind> kTable[] = {{GroupRecipe::Kind::kDining, "dining"},
                                                             {GroupRecipe::Kind::kDesk, "desk"},
                                                             {GroupRecipe::Kind::kMeeting, "meeting"},
                                                             {GroupRecipe::Kind::kFree, "free"}};
};

namespace {

constexpr int kCheckedDraws = 32;

// A key of a section: a distribution of numbers within the limits, or of the words.
struct Field {
  std::string key;
  Distribution* field;
  double min = 0, max = 0;
  std::vector<std::string> words{};
};

void ReadSection(const YamlMap& map, const std::vector<Field>& fields, std::vector<std::string> more = {}) {
  for (const Field& field : fields) more.push_back(field.key);
  map.CheckKeys(more);
  for (const Field& field : fields) {
    if (!map.Has(field.key)) continue;
    *field.field = field.words.empty() ? ReadNumbers(map, field.key, field.min, field.max)
                                       : ReadWords(map, field.key, field.words);
  }
}

void ReadCameraRecipe(const YamlMap& map, CameraRecipe* camera) {
  ReadSection(map, {{"focal", &camera->focal, 0.2, 5}}, {"size"});
  if (!map.Has("size")) return;
  camera->size = ReadAny(map, "size");
  static const std::regex kSize("[1-9][0-9]{1,3}x[1-9][0-9]{1,3}");
  for (const std::string& value : camera->size.values) {
    if (std::regex_match(value, kSize)) continue;
    throw InputError(map.At("size", fmt::format("is {}; write WIDTHxHEIGHT, as 640x480", Quoted(value))));
  }
  if (camera->size.values.empty())
    throw InputError(map.At("size", "is no choice of sizes; write {choice: [640x480, 480x640]}"));
}

void ReadRoomRecipe(const YamlMap& map, RoomRecipe* room) {
  const std::vector<std::string> textures{"plain", "wood", "fabric", "carpet", "tiles", "boards"};
  ReadSection(map, {{"width", &room->width, 2, 50},
                    {"depth", &room->depth, 2, 50},
                    {"height", &room->height, 2, 10},
                    {"floor", &room->floor, 0, 0, textures},
                    {"walls", &room->walls, 0, 0, textures},
                    {"pictures", &room->pictures, 0, 100},
                    {"clutter", &room->clutter, 0, 200},
                    {"table_clutter", &room->table_clutter, 0, 50},
                    {"seat_clutter", &room->seat_clutter, 0, 1},
                    {"lamps", &room->lamps, 1, 12},
                    {"warmth", &room->warmth, 0, 1}});
}

GroupRecipe ReadGroup(const YamlMap& map) {
  GroupRecipe group;
  if (!map.Has("group")) throw InputError(map.At("group", "is missing; write dining, desk, meeting or free"));
  ReadField(map, Option("group", &group.kind, ""));
  if (group.kind == GroupRecipe::Kind::kMeeting) group.chairs = Uniform(6, 14);
  if (group.kind == GroupRecipe::Kind::kDesk) group.chairs = Constant(1);
  if (group.kind == GroupRecipe::Kind::kFree) {
    ReadSection(map,
                {{"count", &group.count, 0, 50}, {"category", &group.category, 0, 0, {"chair", "table"}}},
                {"group"});
    return group;
  }
  ReadSection(map,
              {{"count", &group.count, 0, 20},
               {"chairs", &group.chairs, 0, 30},
               {"gap", &group.gap, -1, 3},
               {"turned_deg", &group.turned_deg, -180, 180},
               {"laptops", &group.laptops, 0, 20}},
              {"group"});
  return group;
}

void ReadFurniture(const YamlMap& map, FurnitureRecipe* furniture) {
  ReadSection(map, {{"seat_height", &furniture->seat_height, 0.2, 1},
                    {"chair_size", &furniture->chair_size, 0.5, 2},
                    {"table_height", &furniture->table_height, 0.2, 1.6},
                    {"laptop_width", &furniture->laptop_width, 0.1, 0.8},
                    {"lid_deg", &furniture->lid_deg, 30, 170},
                    {"alike", &furniture->alike, 0, 1}});
}

void ReadPathRecipe(const YamlMap& map, PathRecipe* path) {
  const std::vector<std::string> kinds{"loop", "turn", "arc", "corridor", "handheld", "close"};
  ReadSection(map, {{"kind", &path->kind, 0, 0, kinds},
                    {"height", &path->height, 0.3, 3},
                    {"pitch_deg", &path->pitch_deg, -45, 80},
                    {"speed", &path->speed, 0.01, 5},
                    {"shake", &path->shake, 0, 5},
                    {"pauses", &path->pauses, 0, 10},
                    {"distance", &path->distance, 0.2, 5},
                    {"overlap", &path->overlap, 0, 2}});
}

// The keys are those of scenes, which a reader of scenes knows: it sees some draws.
template <typename Reader>
DrawnSection ReadCheckedSection(const YamlMap& map, const Recipe& recipe, const std::string& name,
                                const Reader& read) {
  const DrawnSection section = ReadDrawnSection(map.MapOrEmpty(name));
  Random random(1);
  for (int i = 0; i < kCheckedDraws; ++i) read(DrawnWithLinesKept(recipe.file, name, section, random));
  return section;
}

void ReadMixture(const YamlMap& map, Recipe* recipe) {
  map.CheckKeys({"name", "about", "mixture"});
  for (const YamlMap& part : map.Maps("mixture")) {
    part.CheckKeys({"recipe", "weight"});
    double weight = 1;
    ReadField(part, Option("weight", &weight, "", 0, 1e6));
    const std::filesystem::path file = recipe->file.parent_path() / part.Text("recipe");
    if (!std::filesystem::is_regular_file(file))
      throw InputError(
          part.At("recipe", fmt::format("is {}, and {} is no file; name a recipe beside this one",
                                        Quoted(part.Text("recipe")), file.string())));
    if (YamlMap::Load(file).Has("mixture"))
      throw InputError(part.At("recipe", "is a mixture itself; name the recipes that it is of"));
    recipe->mixture.push_back(ReadRecipe(file));
    recipe->weights.push_back(weight);
  }
  if (std::accumulate(recipe->weights.begin(), recipe->weights.end(), 0.0) <= 0)
    throw InputError(map.At("mixture", "has no recipe of a weight above 0; add one"));
}

}  // namespace

Recipe ReadRecipe(const std::filesystem::path& file) {
  const YamlMap map = YamlMap::Load(file);
  Recipe recipe;
  recipe.file = file;
  recipe.name = ReadName(map, "name");
  if (map.Has("about")) recipe.about = map.Text("about");
  if (map.Has("mixture")) {
    ReadMixture(map, &recipe);
    return recipe;
  }
  ReadSection(map, {{"frames", &recipe.frames, 1, 100000}, {"fps", &recipe.fps, 0.01, 1000}},
              {"name", "about", "camera", "room", "light_grid", "layout", "furniture", "distractors", "path",
               "effects", "odometry", "detections"});
  ReadField(map, Option("light_grid", &recipe.light_grid, "", 0.005, 1));
  ReadCameraRecipe(map.MapOrEmpty("camera"), &recipe.camera);
  ReadRoomRecipe(map.MapOrEmpty("room"), &recipe.room);
  if (!map.Has("layout")) throw InputError(map.At("layout", "is missing; list what stands in the room"));
  for (const YamlMap& group : map.Maps("layout")) recipe.layout.push_back(ReadGroup(group));
  ReadFurniture(map.MapOrEmpty("furniture"), &recipe.furniture);
  ReadSection(map.MapOrEmpty("distractors"), {{"count", &recipe.distractors.count, 0, 50},
                                              {"shape", &recipe.distractors.shape, 0, 0, DistractorShapes()},
                                              {"hiding", &recipe.distractors.hiding, 0, 1}});
  ReadPathRecipe(map.MapOrEmpty("path"), &recipe.path);
  recipe.effects = ReadCheckedSection(map, recipe, "effects", ReadEffects);
  recipe.odometry = ReadCheckedSection(map, recipe, "odometry", ReadOdometryNoise);
  recipe.detections = ReadCheckedSection(map, recipe, "detections", ReadDetectorNoise);
  return recipe;
}

}  // namespace armature
