// SPDX-License-Identifier: BSD-3-Clause
#include "app/reproduce/matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "io/sequence.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

// Names that the user wants of one kind; all where none is named.
class Wanted {
 public:
  Wanted(const std::vector<std::string>& names, const std::vector<std::string>& of_kind) {
    for (const std::string& name : names) {
      if (std::find(of_kind.begin(), of_kind.end(), name) != of_kind.end()) names_.insert(name);
    }
  }
  bool Has(const std::string& name) const { return names_.empty() || names_.contains(name); }
  bool Names(const std::string& name) const { return names_.contains(name); }
  void Add(const std::string& name) { names_.insert(name); }

 private:
  std::set<std::string> names_;
};

std::vector<std::string> VariantNames(const Matrix& matrix) {
  std::vector<std::string> names;
  for (const Variant& variant : matrix.variants) names.push_back(variant.name);
  return names;
}

std::vector<std::string> TimingNames(const Matrix& matrix) {
  std::vector<std::string> names;
  for (const Timing& timing : matrix.timings) names.push_back(timing.name);
  return names;
}

void CheckKnown(const std::vector<std::string>& names, const Matrix& matrix) {
  std::vector<std::string> known = FamilyNames(matrix);
  for (const auto& more : {VariantNames(matrix), TimingNames(matrix)})
    known.insert(known.end(), more.begin(), more.end());
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InputError("--only: " + UnknownNameMessage("sequence, variant or timing", name, known));
  }
}

bool IsAmong(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Empty where the file is not there or malformed, which its run will say.
std::string ReadNameIfAny(const fs::path& sequence) {
  try {
    return ReadSequenceSettings(sequence / "sequence.yaml").name;
  } catch (const InputError&) {
    return "";
  }
}

void KeepVariants(Wanted wanted, Matrix& matrix) {
  for (const Variant& variant : matrix.variants) {
    if (!variant.IsRun() && wanted.Names(variant.name)) wanted.Add(variant.odometry_of);
  }
  std::erase_if(matrix.variants, [&](const Variant& variant) { return !wanted.Has(variant.name); });
  std::erase_if(matrix.retrieval, [&](const std::string& name) { return !wanted.Has(name); });
}

void KeepSequences(const Wanted& wanted, Matrix& matrix) {
  std::erase_if(matrix.scenes, [&](const std::string& name) { return !wanted.Has(name); });
  std::erase_if(matrix.sequences,
                [&](const fs::path& folder) { return !wanted.Has(folder.filename().string()); });
  if (matrix.rooms && !wanted.Has(matrix.rooms->name)) matrix.rooms.reset();
  std::erase_if(matrix.timings, [&](Timing& timing) {
    const bool needs_sequences = !timing.sequences.empty();
    std::erase_if(timing.sequences, [&](const std::string& name) { return !wanted.Has(name); });
    return needs_sequences && timing.sequences.empty();
  });
}

// Absolute, and without a slash at its end: its last part is the folder's name.
fs::path FolderWithName(const fs::path& folder) {
  const fs::path absolute = fs::absolute(folder).lexically_normal();
  return absolute.has_filename() ? absolute : absolute.parent_path();
}

// With what is only made from rendered scenes.
void ClearSequences(Matrix& matrix) {
  matrix.scenes.clear();
  matrix.sequences.clear();
  matrix.rooms.reset();
  matrix.categories.clear();
  if (matrix.cad.empty()) matrix.retrieval.clear();
}

Variant FindVariant(const std::string& name, const fs::path& configs, const Matrix& matrix) {
  const auto own = std::find_if(matrix.variants.begin(), matrix.variants.end(),
                                [&](const Variant& variant) { return variant.name == name; });
  if (own != matrix.variants.end()) return *own;
  Variant variant{.name = name, .about = name};
  if (fs::exists(configs / "presets" / (name + ".yaml"))) {
    variant.preset = name;
    return variant;
  }
  variant.config = configs / "ablations" / (name + ".yaml");
  if (fs::exists(variant.config)) return variant;
  std::vector<std::string> known = VariantNames(matrix);
  for (const char* folder : {"presets", "ablations"}) {
    std::error_code absent;
    for (const auto& entry : fs::directory_iterator(configs / folder, absent))
      known.push_back(entry.path().stem().string());
  }
  throw InputError("--variants: " + UnknownNameMessage("variant, preset or ablation", name, known));
}

}  // namespace

std::vector<std::string> FamilyNames(const Matrix& matrix) {
  std::vector<std::string> names = matrix.scenes;
  for (const fs::path& folder : matrix.sequences) names.push_back(folder.filename().string());
  if (matrix.rooms) names.push_back(matrix.rooms->name);
  return names;
}

std::vector<std::string> RunVariants(const Matrix& matrix) {
  std::vector<std::string> names;
  for (const Variant& variant : matrix.variants) {
    if (variant.IsRun()) names.push_back(variant.name);
  }
  return names;
}

void KeepOnly(const std::vector<std::string>& names, Matrix& matrix) {
  CheckKnown(names, matrix);
  const Wanted timings(names, TimingNames(matrix));
  std::erase_if(matrix.timings, [&](const Timing& timing) { return !timings.Names(timing.name); });
  KeepVariants(Wanted(names, VariantNames(matrix)), matrix);
  KeepSequences(Wanted(names, FamilyNames(matrix)), matrix);
}

void ReplaceSequences(const std::vector<fs::path>& folders, Matrix& matrix) {
  ClearSequences(matrix);
  for (const fs::path& folder : folders) {
    if (!fs::exists(folder / "sequence.yaml"))
      throw InputError(fmt::format("{}: is no sequence: it has no sequence.yaml", folder.string()));
    const fs::path absolute = FolderWithName(folder);
    const std::vector<std::string> names = FamilyNames(matrix);
    if (std::find(names.begin(), names.end(), absolute.filename().string()) != names.end())
      throw InputError(fmt::format("{}: another sequence's folder has this name, and runs are named by it",
                                   folder.string()));
    matrix.sequences.push_back(absolute);
  }
  for (Timing& timing : matrix.timings) {
    if (!timing.sequences.empty()) timing.sequences = FamilyNames(matrix);
  }
}

void ReplaceByRooms(const RoomSet& rooms, Matrix& matrix) {
  ClearSequences(matrix);
  matrix.timings.clear();
  matrix.rooms = rooms;
}

void SelectVariants(const std::vector<std::string>& names, const fs::path& configs, Matrix& matrix) {
  std::vector<Variant> selected;
  for (const std::string& name : names) {
    const bool is_there = std::any_of(selected.begin(), selected.end(),
                                      [&](const Variant& variant) { return variant.name == name; });
    if (is_there) throw InputError(fmt::format("--variants: has '{}' twice", name));
    selected.push_back(FindVariant(name, configs, matrix));
  }
  matrix.variants = std::move(selected);
  for (const Variant& variant : matrix.variants) {
    if (!variant.IsRun() && !IsAmong(RunVariants(matrix), variant.odometry_of))
      throw InputError(
          fmt::format("--variants: '{}' needs '{}'; name both", variant.name, variant.odometry_of));
  }
  std::erase_if(matrix.retrieval,
                [&](const std::string& name) { return !IsAmong(RunVariants(matrix), name); });
}

void AddDetections(const std::vector<fs::path>& folders, Matrix& matrix) {
  const std::vector<Variant> without = matrix.variants;
  for (const fs::path& given : folders) {
    if (!fs::is_directory(given))
      throw InputError(fmt::format("--detections: {} is no folder; name one that has <sequence>.csv each",
                                   given.string()));
    const fs::path folder = FolderWithName(given);
    const std::string of = folder.filename().string();
    for (Variant variant : without) {
      if (!variant.IsRun() || !variant.detections.empty()) continue;
      variant.name += "-" + of;
      variant.about += ", " + of;
      variant.detections = folder;
      if (IsAmong(VariantNames(matrix), variant.name))
        throw InputError(
            fmt::format("--detections: two variants would be '{}'; rename the folder", variant.name));
      matrix.variants.push_back(std::move(variant));
    }
  }
}

void CheckNamesDiffer(const Matrix& matrix) {
  std::map<std::string, std::string> where;
  for (const MatrixSequence& sequence : ListSequences(matrix)) {
    const bool is_rendered = IsAmong(matrix.scenes, sequence.family);
    const std::string name = is_rendered ? sequence.name : ReadNameIfAny(sequence.folder);
    if (name.empty()) continue;
    const auto [first, is_new] = where.emplace(name, sequence.folder.string());
    if (is_new) continue;
    throw InputError(
        fmt::format("{}: is called {} in its sequence.yaml as {} is, and results are told apart by "
                    "that name; give it another",
                    sequence.folder.string(), Quoted(name), first->second));
  }
}

fs::path LocateDraw(const Matrix& matrix, int draw) {
  const fs::path data = fs::absolute(matrix.data).lexically_normal();
  return draw == 1 ? data : data / fmt::format("draw{}", draw);
}

std::string KindOfRooms(const RoomSet& rooms) {
  std::string kind;
  for (const fs::path& collection : rooms.collections)
    kind += "-" + FolderWithName(collection).filename().string();
  return rooms.lines_only ? kind + "-lines" : kind;
}

fs::path LocateRooms(const Matrix& matrix) {
  return fs::absolute(matrix.data / ("rooms" + KindOfRooms(matrix.rooms.value()))).lexically_normal();
}

std::string NameRoom(const RoomSet& rooms, int number) {
  return fmt::format("{}-{}-{:03}", rooms.name, rooms.split, number);
}

std::vector<MatrixSequence> ListSequences(const Matrix& matrix) {
  std::vector<MatrixSequence> sequences;
  for (int draw = 1; draw <= matrix.seeds; ++draw) {
    for (const std::string& scene : matrix.scenes) {
      const std::string name = NameDraw(scene, draw);
      sequences.push_back({name, scene, draw, LocateDraw(matrix, draw) / name, {}});
    }
  }
  for (const fs::path& folder : matrix.sequences)
    sequences.push_back({folder.filename().string(), folder.filename().string(), 1, folder, {}});
  for (int number = 0; matrix.rooms && number < matrix.rooms->count; ++number) {
    const std::string name = NameRoom(*matrix.rooms, number);
    sequences.push_back({name, matrix.rooms->name, 1, LocateRooms(matrix) / name, number});
  }
  return sequences;
}

}  // namespace armature
