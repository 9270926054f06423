// SPDX-License-Identifier: BSD-3-Clause
#include "io/training_models.h"

#include <fmt/format.h>

#include "base/errors.h"
#include "category/kept_apart.h"
#include "category/normalise.h"
#include "io/annotations.h"

namespace armature {
namespace {

void AddIfPlausible(const TrainingSpec& spec, const Wireframe& wireframe, TrainingModels& models) {
  ++models.read;
  if (spec.plausible.Contains(BoundingBoxSize(wireframe))) models.wireframes.push_back(wireframe);
}

Wireframe InMetres(const TrainingSpec& spec, const Wireframe& wireframe, bool metric) {
  return metric ? Centred(wireframe) : Normalised(spec.category.reference, wireframe);
}

}  // namespace

TrainingModels AnnotatedTrainingModels(const TrainingSpec& spec, const AnnotatedFile& annotations) {
  TrainingModels models;
  models.source = fmt::format("{} (format {}{}{})", annotations.file.filename().string(), annotations.format,
                              annotations.metric ? ", metric" : "",
                              annotations.without_kept_apart ? ", without those of rooms" : "");
  for (const AnnotatedModel& annotated :
       ReadAnnotations(annotations.file, annotations.format, spec.category)) {
    if (annotations.without_kept_apart && IsKeptApart(annotated.id)) continue;
    try {
      AddIfPlausible(spec, InMetres(spec, annotated.wireframe, annotations.metric), models);
    } catch (const InputError& error) {
      throw InputError(
          fmt::format("{}: model '{}': {}", annotations.file.string(), annotated.id, error.what()));
    }
  }
  return models;
}

TrainingModels FamilyTrainingModels(const TrainingSpec& spec, const FamilySample& sample,
                                    const FamilyMembers& members) {
  const std::vector<std::string>& names = members.edge_names;
  if (spec.category.edge_names != names) {
    throw InputError(
        fmt::format("family {} has the edges [{}], but category {} has [{}]; use the family's own "
                    "specification",
                    sample.family, fmt::join(names, ", "), spec.category.name,
                    fmt::join(spec.category.edge_names, ", ")));
  }
  TrainingModels models;
  models.source = fmt::format("our own family of {}s (datasets/cad, BSD-3-Clause), {} members, seed {}",
                              sample.family, sample.count, sample.seed);
  for (const Wireframe& wireframe : members.wireframes) {
    AddIfPlausible(spec, InMetres(spec, wireframe, sample.metric), models);
  }
  return models;
}

}  // namespace armature
