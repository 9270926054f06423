// SPDX-License-Identifier: BSD-3-Clause
#include "eval/budget/true_models.h"

#include <fmt/format.h>

#include "category/category_lookup.h"
#include "category/normalise.h"
#include "io/category_yaml.h"

namespace armature {
namespace {

constexpr double kKnown = 0.01;          // of the deviations: solvers need some
constexpr double kLeastExtent_m = 1e-3;  // of edges whose padding is all of the object
constexpr double kFlat_m = 1e-9;         // wireframes without extent have no scale

}  // namespace

CategoryModel ModelOfSize(CategoryModel model, const Eigen::Vector3d& size) {
  Wireframe mean = Centred(WireframeFromVector(model.mean));
  const Eigen::Vector3d extent = BoundingBoxSize(mean);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (extent[axis] < kFlat_m) continue;
    const double edges = std::max(size[axis] - 2 * model.spec.padding[axis], kLeastExtent_m);
    mean.midpoints.row(axis) *= edges / extent[axis];
    mean.directions.row(axis) *= edges / extent[axis];
  }
  model.mean = ShapeVector(mean);
  model.standard_deviations *= kKnown;
  model.total_variance *= kKnown * kKnown;
  model.dictionary = {Eigen::VectorXd::Zero(model.modes())};
  model.spec.size_sigma *= kKnown;
  model.spec.reference.metres = Measure(model.spec.reference, mean);
  return model;
}

SubstitutedFiles ModelsOfObjects(const std::vector<TrueObject>& objects,
                                 const std::vector<CategoryModel>& models, bool sized) {
  SubstitutedFiles files;
  for (const TrueObject& object : objects) {
    CategoryModel model = LookUpModel(models, object.category);
    if (sized) model = ModelOfSize(std::move(model), object.size);
    model.spec.name = object.id;
    files[fmt::format("{}/{}.yaml", kModelsFolder, object.id)] = CategoryText(model);
  }
  return files;
}

}  // namespace armature
