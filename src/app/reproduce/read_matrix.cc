// SPDX-License-Identifier: BSD-3-Clause
#include "app/reproduce/read_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "io/yaml_support.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

// Names of folders and of rows.
std::string PlainName(const YamlMap& map, const std::string& key) {
  const std::string name = map.Text(key);
  const bool is_plain = !name.empty() && name != "." && name != ".." &&
                        name.find_first_of("/\\ \t\"'") == std::string::npos && name.front() != '-';
  if (!is_plain) throw InputError(map.At(key, "has to be a name without blanks, quotes and slashes"));
  return name;
}

LearntCategory ReadCategory(const std::string& name, const YamlMap& map) {
  map.CheckKeys({"padding", "slab_drop"});
  LearntCategory category{.name = name};
  if (map.Has("padding")) {
    const std::vector<double> padding = map.Numbers("padding");
    if (padding.size() != 3) throw InputError(map.At("padding", "has to be three numbers, metres"));
    std::copy(padding.begin(), padding.end(), category.padding.begin());
  }
  if (map.Has("slab_drop")) category.slab_drop = map.Number("slab_drop");
  return category;
}

Variant ReadVariant(const YamlMap& map, const fs::path& beside) {
  map.CheckKeys({"name", "about", "preset", "config", "detections", "odometry_of"});
  Variant variant{.name = PlainName(map, "name")};
  variant.about = map.Has("about") ? map.Text("about") : variant.name;
  if (map.Has("preset")) variant.preset = map.Text("preset");
  if (map.Has("config")) {
    variant.config = (beside / map.Text("config")).lexically_normal();
    if (!fs::is_regular_file(variant.config))
      throw InputError(map.At("config", fmt::format("{} is not there", variant.config.string())));
  }
  if (map.Has("detections")) {
    variant.detections = (beside / map.Text("detections")).lexically_normal();
    if (!fs::is_directory(variant.detections))
      throw InputError(
          map.At("detections", fmt::format("{} is no folder; name one that has <sequence>.csv each",
                                           variant.detections.string())));
  }
  if (map.Has("odometry_of")) variant.odometry_of = map.Text("odometry_of");
  return variant;
}

Timing ReadTiming(const YamlMap& map) {
  map.CheckKeys({"name", "sequences", "tables", "engines", "frames", "baseline_frames"});
  Timing timing{.name = PlainName(map, "name")};
  if (map.Has("sequences")) timing.sequences = map.Texts("sequences");
  timing.tables = map.Texts("tables");
  if (map.Has("engines")) timing.engines = map.Texts("engines");
  if (map.Has("frames")) timing.frames = map.Integer("frames");
  if (map.Has("baseline_frames")) timing.baseline_frames = map.Integer("baseline_frames");
  return timing;
}

RoomSet ReadRooms(const YamlMap& map, const fs::path& beside) {
  map.CheckKeys({"recipe", "count", "split", "seed", "collections", "lines_only"});
  RoomSet rooms = ReadRoomSet(beside / map.Text("recipe"));
  if (map.Has("count")) rooms.count = map.Integer("count");
  if (rooms.count < 1) throw InputError(map.At("count", "has to be 1 or more"));
  if (map.Has("split") && map.Has("seed")) throw InputError(map.At("seed", "and `split` exclude each other"));
  if (map.Has("split")) {
    rooms.split = map.Text("split");
    if (std::find(kRoomSplits.begin(), kRoomSplits.end(), rooms.split) == kRoomSplits.end())
      throw InputError(map.At(
          "split", UnknownNameMessage("split", rooms.split, {kRoomSplits.begin(), kRoomSplits.end()})));
  }
  if (map.Has("seed")) {
    if (map.Integer("seed") < 0) throw InputError(map.At("seed", "has to be 0 or more"));
    rooms.split = std::to_string(map.Integer("seed"));
  }
  if (map.Has("collections")) {
    for (const std::string& folder : map.Texts("collections"))
      rooms.collections.push_back((beside / folder).lexically_normal());
  }
  if (map.Has("lines_only")) rooms.lines_only = map.Boolean("lines_only");
  return rooms;
}

void ReadSequences(const YamlMap& map, const fs::path& beside, Matrix& matrix) {
  if (map.Has("data")) matrix.data = map.Text("data");
  if (map.Has("scenes")) matrix.scenes = map.Texts("scenes");
  if (map.Has("seeds")) matrix.seeds = map.Integer("seeds");
  if (map.Has("frames")) matrix.frames = map.Integer("frames");
  if (map.Has("rooms")) matrix.rooms = ReadRooms(map.Map("rooms"), beside);
  if (!map.Has("sequences")) return;
  matrix.sequences.clear();
  for (const std::string& folder : map.Texts("sequences")) {
    fs::path sequence = (beside / folder).lexically_normal();
    if (!sequence.has_filename()) sequence = sequence.parent_path();  // a slash at its end
    matrix.sequences.push_back(sequence);
  }
}

// What the map names replaces what is there.
void Read(const YamlMap& map, const fs::path& beside, Matrix& matrix) {
  if (map.Has("name")) matrix.name = PlainName(map, "name");
  ReadSequences(map, beside, matrix);
  if (map.Has("categories")) {
    matrix.categories.clear();
    const YamlMap categories = map.Map("categories");
    for (const std::string& name : categories.Keys())
      matrix.categories.push_back(ReadCategory(name, categories.MapOrEmpty(name)));
  }
  if (map.Has("category_folder"))
    matrix.category_folder = (beside / map.Text("category_folder")).lexically_normal();
  if (map.Has("variants")) {
    matrix.variants.clear();
    for (const YamlMap& variant : map.Maps("variants"))
      matrix.variants.push_back(ReadVariant(variant, beside));
  }
  if (map.Has("retrieval")) matrix.retrieval = map.Texts("retrieval");
  if (map.Has("library_every")) matrix.library_every = map.Integer("library_every");
  if (map.Has("cad")) matrix.cad = (beside / map.Text("cad")).lexically_normal();
  if (map.Has("jitter")) matrix.jitter = map.Integer("jitter");
  if (map.Has("timings")) {
    matrix.timings.clear();
    for (const YamlMap& timing : map.Maps("timings")) matrix.timings.push_back(ReadTiming(timing));
  }
}

const std::vector<std::string> kKeys{"name",     "data",      "scenes",        "sequences",
                                     "seeds",    "frames",    "categories",    "category_folder",
                                     "variants", "retrieval", "library_every", "cad",
                                     "timings",  "rooms",     "jitter"};

template <typename Named>
std::vector<std::string> ListNames(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const Named& one : all) names.push_back(one.name);
  return names;
}

bool Has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void CheckDistinct(const YamlMap& map, const std::string& key, const std::vector<std::string>& names) {
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (!seen.insert(name).second) throw InputError(map.At(key, fmt::format("has '{}' twice", name)));
  }
}

void CheckKnown(const YamlMap& map, const std::string& key, const std::string& what, const std::string& name,
                const std::vector<std::string>& known) {
  if (!Has(known, name)) throw InputError(map.At(key, UnknownNameMessage(what, name, known)));
}

void CheckNumbers(const YamlMap& map, const Matrix& matrix) {
  if (matrix.seeds < 1) throw InputError(map.At("seeds", "has to be 1 or more"));
  if (matrix.frames < 0) throw InputError(map.At("frames", "has to be 1 or more, 0 for all"));
  if (matrix.jitter < 0) throw InputError(map.At("jitter", "has to be 1 or more, 0 for none"));
  if (matrix.library_every < 0) throw InputError(map.At("library_every", "has to be 1 or more, 0 for none"));
}

// What the matrix's own sequences are to be: scenes are rendered, the others are there.
void CheckSequences(const YamlMap& map, const Matrix& matrix) {
  const std::vector<std::string> families = FamilyNames(matrix);
  if (families.empty()) {
    throw InputError(
        map.At("scenes",
               "and `sequences` are empty: nothing to run; add one, or `rooms`, or name sequence "
               "folders in the call"));
  }
  CheckDistinct(map, "sequences", families);
  for (const Timing& timing : matrix.timings) {
    for (const std::string& name : timing.sequences) CheckKnown(map, "timings", "sequence", name, families);
  }
  const bool renders = !matrix.scenes.empty();
  if ((renders || matrix.rooms) && matrix.data.empty())
    throw InputError(map.At("data", "has to name a folder for the scenes"));
  if (!renders && !matrix.retrieval.empty() && matrix.cad.empty())
    throw InputError(
        map.At("retrieval", "needs CAD models, which come with the scenes or from the folder `cad`"));
  if (!renders && !matrix.categories.empty())
    throw InputError(
        map.At("categories", "are learnt from the rendered scenes' CAD models, but there is no scene"));
}

void CheckMatrix(const YamlMap& map, const Matrix& matrix) {
  const std::vector<std::string> runs = RunVariants(matrix);
  if (runs.empty()) throw InputError(map.At("variants", "has nothing to run"));
  CheckDistinct(map, "variants", ListNames(matrix.variants));
  CheckDistinct(map, "timings", ListNames(matrix.timings));
  for (const Variant& variant : matrix.variants) {
    if (!variant.IsRun()) CheckKnown(map, "variants", "variant", variant.odometry_of, runs);
  }
  for (const std::string& name : matrix.retrieval) CheckKnown(map, "retrieval", "variant", name, runs);
  CheckNumbers(map, matrix);
}

}  // namespace

RoomSet ReadRoomSet(const fs::path& recipe) {
  const fs::path absolute = fs::absolute(recipe).lexically_normal();
  return {.recipe = absolute, .name = PlainName(YamlMap::Load(absolute), "name")};
}

Matrix ReadMatrix(const fs::path& file, const MatrixReading& reading) {
  const YamlMap map = YamlMap::Load(file);
  std::vector<std::string> keys = kKeys;
  keys.push_back("fast");
  map.CheckKeys(keys);
  const fs::path beside = fs::absolute(file).parent_path();
  Matrix matrix;
  Read(map, beside, matrix);
  if (reading.fast) {
    if (!map.Has("fast")) throw InputError(map.At("fast", "is missing: it says what --fast leaves out"));
    map.Map("fast").CheckKeys(kKeys);
    Read(map.Map("fast"), beside, matrix);
  }
  CheckMatrix(map, matrix);
  if (!reading.has_own_sequences) CheckSequences(map, matrix);
  return matrix;
}

}  // namespace armature
