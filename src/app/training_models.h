// SPDX-License-Identifier: BSD-3-Clause
// Where `armature learn` takes its models from.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "category/training_spec.h"

namespace armature {

struct TrainingModels {
  std::vector<Wireframe> wireframes;  // metres, centred, plausible
  int read = 0;                       // how many there were before implausible ones were left out
  std::string source;                 // what they are
};

// Annotated models scaled by the category's metric reference. Throws InputError naming the file (and the
// model).
TrainingModels AnnotatedTrainingModels(const TrainingSpec& spec, const std::filesystem::path& annotations,
                                       const std::string& format);

// Members of a family, which are in metres already: their sizes keep the family's spread. Throws InputError
// for an unknown family or one with other edges than the specification's.
TrainingModels FamilyTrainingModels(const TrainingSpec& spec, const std::string& family, int count,
                                    std::uint64_t seed);

}  // namespace armature
