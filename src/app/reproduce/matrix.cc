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
  std::erase_if(matrix.timings, [&](Timing& timing) {
    const bool needs_sequences = !timing.sequences.empty();
    std::erase_if(timing.sequences, [&](const std::string& name) { return !wanted.Has(name); });
    return needs_sequences && timing.sequences.empty();
  });
}

}  // namespace

std::vector<std::string> FamilyNames(const Matrix& matrix) {
  std::vector<std::string> names = matrix.scenes;
  for (const fs::path& folder : matrix.sequences) names.push_back(folder.filename().string());
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
  matrix.scenes.clear();
  matrix.sequences.clear();
  matrix.categories.clear();
  if (matrix.cad.empty()) matrix.retrieval.clear();
  for (const fs::path& folder : folders) {
    if (!fs::exists(folder / "sequence.yaml"))
      throw InputError(fmt::format("{}: is no sequence: it has no sequence.yaml", folder.string()));
    fs::path absolute = fs::absolute(folder).lexically_normal();
    if (!absolute.has_filename()) absolute = absolute.parent_path();
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

std::vector<MatrixSequence> ListSequences(const Matrix& matrix) {
  std::vector<MatrixSequence> sequences;
  for (int draw = 1; draw <= matrix.seeds; ++draw) {
    for (const std::string& scene : matrix.scenes) {
      const std::string name = NameDraw(scene, draw);
      sequences.push_back({name, scene, draw, LocateDraw(matrix, draw) / name});
    }
  }
  for (const fs::path& folder : matrix.sequences)
    sequences.push_back({folder.filename().string(), folder.filename().string(), 1, folder});
  return sequences;
}

}  // namespace armature
