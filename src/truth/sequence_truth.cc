// SPDX-License-Identifier: BSD-3-Clause
#include "truth/sequence_truth.h"

#include "io/sequence.h"

namespace armature {

SequenceTruth LoadSequenceTruth(const std::filesystem::path& folder, const std::vector<CategorySpec>& specs) {
  const SequenceSettings settings = ReadSequenceSettings(folder / "sequence.yaml");
  SequenceTruth sequence{settings.name, settings.camera, LoadGroundTruth(folder), {}};
  if (std::filesystem::exists(folder / kTrueEdgesFile))
    sequence.edges.emplace(folder / kTrueEdgesFile, sequence.truth, specs);
  return sequence;
}

}  // namespace armature
