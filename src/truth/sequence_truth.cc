// SPDX-License-Identifier: BSD-3-Clause
#include "truth/sequence_truth.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "io/sequence.h"

namespace armature {
namespace {

void CheckCategories(const std::filesystem::path& file, const std::vector<TrueObject>& objects,
                     const std::vector<CategorySpec>& specs) {
  std::vector<std::string> known;
  for (const CategorySpec& spec : specs) known.push_back(spec.name);
  for (const TrueObject& object : objects) {
    if (std::find(known.begin(), known.end(), object.category) != known.end()) continue;
    throw InputError(fmt::format("{}:{}: {}; --categories names the folder of its model", file.string(),
                                 object.line, UnknownNameMessage("category", object.category, known)));
  }
}

}  // namespace

SequenceTruth LoadSequenceTruth(const std::filesystem::path& folder, const std::vector<CategorySpec>& specs) {
  const SequenceSettings settings = ReadSequenceSettings(folder / "sequence.yaml");
  SequenceTruth sequence{settings.name, settings.camera, LoadGroundTruth(folder), {}};
  CheckCategories(folder / "objects_gt.csv", sequence.truth.objects, specs);
  if (std::filesystem::exists(folder / kTrueEdgesFile))
    sequence.edges.emplace(folder / kTrueEdgesFile, sequence.truth, specs);
  return sequence;
}

}  // namespace armature
