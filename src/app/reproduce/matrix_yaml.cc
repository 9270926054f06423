// SPDX-License-Identifier: BSD-3-Clause
#include "app/reproduce/matrix_yaml.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>

namespace armature {
namespace {

namespace fs = std::filesystem;

template <typename Value>
void Emit(const std::string& key, const Value& value, YAML::Emitter& yaml) {
  yaml << YAML::Key << key << YAML::Value << YAML::Flow << value;
}

void EmitCategories(const Matrix& matrix, YAML::Emitter& yaml) {
  yaml << YAML::Key << "categories" << YAML::Value << YAML::BeginMap;
  for (const LearntCategory& category : matrix.categories) {
    yaml << YAML::Key << category.name << YAML::Value << YAML::BeginMap;
    Emit("padding", std::vector<double>(category.padding.begin(), category.padding.end()), yaml);
    if (category.slab_drop) Emit("slab_drop", *category.slab_drop, yaml);
    yaml << YAML::EndMap;
  }
  yaml << YAML::EndMap;
}

void EmitRooms(const RoomSet& rooms, YAML::Emitter& yaml) {
  yaml << YAML::Key << "rooms" << YAML::Value << YAML::BeginMap;
  Emit("recipe", rooms.recipe.string(), yaml);
  Emit("count", rooms.count, yaml);
  const bool is_split = std::find(kRoomSplits.begin(), kRoomSplits.end(), rooms.split) != kRoomSplits.end();
  Emit(is_split ? "split" : "seed", rooms.split, yaml);
  std::vector<std::string> collections;
  for (const fs::path& folder : rooms.collections) collections.push_back(folder.string());
  if (!collections.empty()) Emit("collections", collections, yaml);
  if (rooms.lines_only) Emit("lines_only", true, yaml);
  yaml << YAML::EndMap;
}

void EmitVariant(const Variant& variant, YAML::Emitter& yaml) {
  yaml << YAML::BeginMap;
  Emit("name", variant.name, yaml);
  Emit("about", variant.about, yaml);
  if (variant.IsRun()) Emit("preset", variant.preset, yaml);
  if (!variant.config.empty()) Emit("config", variant.config.string(), yaml);
  if (!variant.detections.empty()) Emit("detections", variant.detections.string(), yaml);
  if (!variant.IsRun()) Emit("odometry_of", variant.odometry_of, yaml);
  yaml << YAML::EndMap;
}

void EmitTiming(const Timing& timing, YAML::Emitter& yaml) {
  yaml << YAML::BeginMap;
  Emit("name", timing.name, yaml);
  Emit("sequences", timing.sequences, yaml);
  Emit("tables", timing.tables, yaml);
  Emit("engines", timing.engines, yaml);
  Emit("frames", timing.frames, yaml);
  Emit("baseline_frames", timing.baseline_frames, yaml);
  yaml << YAML::EndMap;
}

}  // namespace

std::string MatrixYaml(const Matrix& matrix) {
  YAML::Emitter yaml;
  yaml << YAML::BeginMap;
  Emit("name", matrix.name, yaml);
  if (!matrix.data.empty()) Emit("data", matrix.data.string(), yaml);
  Emit("scenes", matrix.scenes, yaml);
  yaml << YAML::Key << "sequences" << YAML::Value << YAML::BeginSeq;
  for (const fs::path& folder : matrix.sequences) yaml << folder.string();
  yaml << YAML::EndSeq;
  if (matrix.rooms) EmitRooms(*matrix.rooms, yaml);
  if (matrix.jitter > 0) Emit("jitter", matrix.jitter, yaml);
  Emit("seeds", matrix.seeds, yaml);
  Emit("frames", matrix.frames, yaml);
  EmitCategories(matrix, yaml);
  if (!matrix.category_folder.empty()) Emit("category_folder", matrix.category_folder.string(), yaml);
  yaml << YAML::Key << "variants" << YAML::Value << YAML::BeginSeq;
  for (const Variant& variant : matrix.variants) EmitVariant(variant, yaml);
  yaml << YAML::EndSeq;
  Emit("retrieval", matrix.retrieval, yaml);
  Emit("library_every", matrix.library_every, yaml);
  if (!matrix.cad.empty()) Emit("cad", matrix.cad.string(), yaml);
  yaml << YAML::Key << "timings" << YAML::Value << YAML::BeginSeq;
  for (const Timing& timing : matrix.timings) EmitTiming(timing, yaml);
  yaml << YAML::EndSeq << YAML::EndMap;
  return yaml.c_str() + std::string("\n");
}

}  // namespace armature
