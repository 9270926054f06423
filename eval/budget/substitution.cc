// SPDX-License-Identifier: BSD-3-Clause
#include "eval/budget/substitution.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "base/write_failure.h"
#include "category/category_lookup.h"
#include "eval/budget/true_detections.h"
#include "eval/budget/true_lines.h"
#include "eval/budget/true_models.h"
#include "eval/budget/true_odometry.h"
#include "io/atomic_write.h"
#include "io/category_yaml.h"
#include "io/json_file.h"
#include "io/output_folder.h"
#include "io/run_folder.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

// Says what a folder is: {"sequence": absolute path, "truth": [names], "complete": true}.
constexpr const char* kMark = "substituted.json";

bool IsSubstitution(const fs::path& folder) { return SaysComplete(folder / kMark); }

const Replaceable& Substitutions() {
  static const Replaceable substitutions{"a sequence by `armature substitute`", IsSubstitution};
  return substitutions;
}

std::vector<const char*> NeededFiles(SubstitutedTruth truth) {
  switch (truth) {
    case SubstitutedTruth::kScale:
      return {"groundtruth.txt", "odometry.txt"};
    case SubstitutedTruth::kCameras:
      return {"groundtruth.txt"};
    case SubstitutedTruth::kLines:
      return {"groundtruth.txt", "objects_gt.csv", "detections_gt.csv", kTrueEdgesFile};
    default:
      return {"groundtruth.txt", "objects_gt.csv", "detections_gt.csv", "detections.csv"};
  }
}

void CheckNeededFiles(const fs::path& sequence, SubstitutedTruth truth) {
  for (const char* file : NeededFiles(truth)) {
    if (fs::exists(sequence / file)) continue;
    throw InputError(
        fmt::format("{}: has no {}, without which the truth '{}' cannot be given; leave it out of --truth",
                    sequence.string(), file, ToName(truth)));
  }
}

SubstitutedFiles GiveIdentities(const fs::path& folder, const SequenceTruth& sequence,
                                const std::vector<CategoryModel>& models, bool sized) {
  SubstitutedFiles files = NameDetectionsByObject(folder, sequence);
  files.merge(ModelsOfObjects(sequence.truth.objects, models, sized));
  return files;
}

nlohmann::ordered_json Mark(const fs::path& sequence, SubstitutedTruth truth) {
  nlohmann::ordered_json truths = nlohmann::ordered_json::array();
  if (const auto earlier = FindJsonObject(sequence / kMark); earlier && earlier->contains("truth"))
    truths = earlier->at("truth");
  truths.push_back(ToName(truth));
  return {{"sequence", OriginOfSequence(sequence).string()}, {"truth", truths}, {"complete", true}};
}

// What takes a file's place takes that of its folder in the sequence.
bool IsReplaced(const std::string& name, const SubstitutedFiles& files) {
  if (name == kMark || files.contains(name)) return true;
  const auto inside = files.lower_bound(name + "/");
  return inside != files.end() && inside->first.starts_with(name + "/");
}

void LinkOthers(const fs::path& sequence, const SubstitutedFiles& files, const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(sequence)) {
    const fs::path name = entry.path().filename();
    if (IsReplaced(name.string(), files) || IsPartial(name)) continue;
    std::error_code failure;
    fs::create_symlink(fs::canonical(entry.path()), folder / name, failure);
    if (!failure) continue;
    fs::copy(entry.path(), folder / name, fs::copy_options::recursive, failure);
    if (failure) throw InputError(WriteFailure(folder / name, failure.value()));
  }
}

}  // namespace

SubstitutedFiles SubstituteTruth(const fs::path& sequence, SubstitutedTruth truth,
                                 const std::vector<CategoryModel>& given) {
  CheckNeededFiles(sequence, truth);
  if (truth == SubstitutedTruth::kScale) return ScaleOdometry(sequence);
  if (truth == SubstitutedTruth::kCameras) return ReplaceOdometry(sequence);
  const std::vector<CategoryModel> models = ModelsOfSequence(sequence, given);
  const SequenceTruth known = LoadSequenceTruth(sequence, CollectSpecs(models));
  switch (truth) {
    case SubstitutedTruth::kViewpoints:
      return ReplaceViewpoints(sequence, known);
    case SubstitutedTruth::kLines:
      return ReplaceLines(sequence);
    case SubstitutedTruth::kIdentities:
      return GiveIdentities(sequence, known, models, false);
    case SubstitutedTruth::kShapes:
      return GiveIdentities(sequence, known, models, true);
    default:
      return KeepTrueDetections(sequence, known);
  }
}

void CheckSubstitution(const fs::path& sequence, const fs::path& folder) {
  if (fs::weakly_canonical(folder) == fs::weakly_canonical(sequence))
    throw InputError(
        fmt::format("{}: is the sequence itself; choose another folder with --out", folder.string()));
  const OutputFolder may_be_written(folder, Substitutions());
}

void WriteSubstitution(const fs::path& sequence, SubstitutedTruth truth, const SubstitutedFiles& files,
                       const fs::path& folder) {
  OutputFolder out(folder, Substitutions());
  for (const auto& [name, content] : files) WriteFile(out.partial() / name, content);
  LinkOthers(sequence, files, out.partial());
  WriteFile(out.partial() / kMark, Mark(sequence, truth).dump(2) + "\n");
  out.Publish();
}

fs::path OriginOfSequence(const fs::path& folder) {
  const auto mark = FindJsonObject(folder / kMark);
  const bool is_named = mark && mark->contains("sequence") && mark->at("sequence").is_string();
  return fs::weakly_canonical(is_named ? fs::path(mark->at("sequence").get<std::string>()) : folder);
}

std::vector<CategoryModel> ModelsOfSequence(const fs::path& folder,
                                            const std::vector<CategoryModel>& models) {
  const bool has_own = IsSubstitution(folder) && fs::exists(folder / kModelsFolder);
  return has_own ? LoadCategories(folder / kModelsFolder) : models;
}

}  // namespace armature
