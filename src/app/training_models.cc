// SPDX-License-Identifier: BSD-3-Clause
#include "app/training_models.h"

#include <fmt/format.h>

#include "category/normalise.h"
#include "datasets/cad/cad_instance.h"
#include "datasets/cad/chair.h"
#include "datasets/cad/laptop.h"
#include "datasets/cad/table.h"
#include "io/annotations.h"
#include "io/errors.h"

namespace armature {
namespace {

void AddIfPlausible(const TrainingSpec& spec, const Wireframe& wireframe, TrainingModels& models) {
  ++models.read;
  if (spec.plausible.Contains(BoundingBoxSize(wireframe))) models.wireframes.push_back(wireframe);
}

// Members of a family, centred as annotated models are.
template <typename Parameters>
std::vector<Wireframe> Centred(const std::vector<Parameters>& members, Wireframe (*make)(const Parameters&)) {
  std::vector<Wireframe> wireframes;
  for (const Parameters& member : members) wireframes.push_back(Centred(make(member)));
  return wireframes;
}

std::vector<Wireframe> FamilyWireframes(const std::string& family, int count, std::uint64_t seed) {
  if (family == "chair") return Centred(SampleChairFamily(count, seed), ChairWireframe);
  if (family == "table") return Centred(SampleTableFamily(count, seed), TableWireframe);
  if (family == "laptop") return Centred(SampleLaptopFamily(count, seed), LaptopWireframe);
  throw InputError(fmt::format("unknown family '{}'; families: chair, table, laptop", family));
}

}  // namespace

TrainingModels AnnotatedTrainingModels(const TrainingSpec& spec, const std::filesystem::path& annotations,
                                       const std::string& format) {
  TrainingModels models;
  models.source = fmt::format("{} (format {})", annotations.filename().string(), format);
  for (const AnnotatedModel& annotated : ReadAnnotations(annotations, format, spec.category)) {
    try {
      AddIfPlausible(spec, Normalised(spec.category.reference, annotated.wireframe), models);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: model '{}': {}", annotations.string(), annotated.id, error.what()));
    }
  }
  return models;
}

TrainingModels FamilyTrainingModels(const TrainingSpec& spec, const std::string& family, int count,
                                    std::uint64_t seed) {
  const std::vector<Wireframe> wireframes = FamilyWireframes(family, count, seed);
  const std::vector<std::string> names = EdgeNames(family);
  if (spec.category.edge_names != names) {
    throw InputError(fmt::format(
        "family {} has the edges [{}], but category {} has [{}]; use the family's own "
        "specification",
        family, fmt::join(names, ", "), spec.category.name, fmt::join(spec.category.edge_names, ", ")));
  }
  TrainingModels models;
  models.source = fmt::format("our own family of {}s (datasets/cad, BSD-3-Clause), {} members, seed {}",
                              family, count, seed);
  for (const Wireframe& wireframe : wireframes) AddIfPlausible(spec, wireframe, models);
  return models;
}

}  // namespace armature
