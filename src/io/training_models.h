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

struct AnnotatedFile {
  std::filesystem::path file;
  std::string format = "edges";     // one of AnnotationFormats()
  bool metric = false;              // in metres already
  bool without_kept_apart = false;  // leave out those that rooms are drawn from (category/kept_apart.h)
};

// Annotated models scaled by the category's metric reference, which gives all of them the same seat height or
// the like; metric ones are not scaled and keep the spread of their sizes. Throws InputError naming the file
// (and the model).
TrainingModels AnnotatedTrainingModels(const TrainingSpec& spec, const AnnotatedFile& annotations);

// Objects made in memory instead of read: members of a family, all in metres.
struct FamilyMembers {
  std::vector<Wireframe> wireframes;
  std::vector<std::string> edge_names;
};

struct FamilySample {
  std::string family;  // chair, table, laptop
  int count = 2000;
  std::uint64_t seed = 1;
  bool metric = true;  // false: scaled as annotated models are
};

// `members`: of the sample. Throws InputError when the category's edges are not the family's.
TrainingModels FamilyTrainingModels(const TrainingSpec& spec, const FamilySample& sample,
                                    const FamilyMembers& members);

}  // namespace armature
