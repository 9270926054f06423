// SPDX-License-Identifier: BSD-3-Clause
#include "retrieval/instance_library.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "base/interrupt.h"
#include "category/normalise.h"

namespace armature {
namespace {

// x_object = scale * (x_annotation - centre).
struct ToMetres {
  double scale = 1;
  Eigen::Vector3d centre{0, 0, 0};  // unit of the annotations
};

std::optional<ToMetres> FindMetres(const CategorySpec& spec, const CadModel& cad) {
  ToMetres to{1, BoundingBoxCenter(cad.wireframe)};
  if (cad.metric) return to;
  const double measure = Measure(spec.reference, cad.wireframe);
  if (measure <= 1e-9) return std::nullopt;
  to.scale = spec.reference.metres / measure;
  return to;
}

Wireframe InMetres(const ToMetres& to, const Wireframe& wireframe) {
  return {to.scale * (wireframe.midpoints.colwise() - to.centre), to.scale * wireframe.directions};
}

void Store(const CategoryModel& model, const CadModel& cad, const ToMetres& to, int column,
           CategoryInstances& instances) {
  const Wireframe wireframe = InMetres(to, cad.wireframe);
  instances.ids.push_back(cad.instance);
  instances.coefficients.col(column) = CoefficientsFromWireframe(model, wireframe).cast<float>();
  instances.edges.col(column) = ShapeVector(wireframe).cast<float>();
  instances.sizes.col(column) = (to.scale * (cad.box_max - cad.box_min)).cast<float>();
  instances.size_sigmas(column) = cad.metric ? 0 : static_cast<float>(kUnscaledSizeSigma);
  instances.geometries.push_back(cad.T_annotation_geometry ? cad.geometry : "");
  const Eigen::Affine3d T_object_annotation = Eigen::Scaling(to.scale) * Eigen::Translation3d(-to.centre);
  const Eigen::Affine3d T =
      T_object_annotation * cad.T_annotation_geometry.value_or(Eigen::Affine3d::Identity());
  instances.T_object_geometry.col(column) = T.affine().reshaped().cast<float>();
}

// Keeps the first columns.
void Resize(Eigen::Index modes, Eigen::Index edges, Eigen::Index count, CategoryInstances& instances) {
  instances.coefficients.conservativeResize(modes, count);
  instances.sizes.conservativeResize(Eigen::NoChange, count);
  instances.edges.conservativeResize(6 * edges, count);
  instances.size_sigmas.conservativeResize(count);
  instances.T_object_geometry.conservativeResize(Eigen::NoChange, count);
}

}  // namespace

int CategoryInstances::Find(const std::string& id) const {
  const auto found = std::find(ids.begin(), ids.end(), id);
  return found == ids.end() ? -1 : static_cast<int>(found - ids.begin());
}

Wireframe CategoryInstances::MakeWireframe(int instance) const {
  return WireframeFromVector(edges.col(instance).cast<double>());
}

Eigen::Affine3d CategoryInstances::MakeTransform(int instance) const {
  Eigen::Affine3d T = Eigen::Affine3d::Identity();
  T.affine() = T_object_geometry.col(instance).cast<double>().reshaped(3, 4);
  return T;
}

const CategoryInstances* InstanceLibrary::Of(const std::string& category) const {
  for (const CategoryInstances& instances : categories) {
    if (instances.category == category) return &instances;
  }
  return nullptr;
}

InstanceLibrary BuildLibrary(const std::vector<CategoryModel>& models, const std::vector<CadModel>& cad,
                             const std::filesystem::path& root) {
  InstanceLibrary library{root, {}};
  for (const CategoryModel& model : models) {
    const auto count = std::count_if(cad.begin(), cad.end(),
                                     [&](const CadModel& c) { return c.category == model.spec.name; });
    CategoryInstances instances{.category = model.spec.name, .model_checksum = ModelChecksum(model)};
    Resize(model.modes(), model.spec.edges(), count, instances);
    for (const CadModel& c : cad) {
      ThrowIfInterrupted();
      if (c.category != model.spec.name) continue;
      if (const auto to = FindMetres(model.spec, c)) Store(model, c, *to, instances.size(), instances);
    }
    Resize(model.modes(), model.spec.edges(), instances.size(), instances);
    if (instances.size() > 0) library.categories.push_back(std::move(instances));
  }
  return library;
}

CategoryInstances Without(const CategoryInstances& instances, const std::vector<int>& leave_out) {
  std::vector<int> kept;
  for (int i = 0; i < instances.size(); ++i) {
    if (std::find(leave_out.begin(), leave_out.end(), i) == leave_out.end()) kept.push_back(i);
  }
  CategoryInstances rest{.category = instances.category, .model_checksum = instances.model_checksum};
  for (const int i : kept) {
    rest.ids.push_back(instances.ids[static_cast<size_t>(i)]);
    rest.geometries.push_back(instances.geometries[static_cast<size_t>(i)]);
  }
  rest.coefficients = instances.coefficients(Eigen::all, kept);
  rest.sizes = instances.sizes(Eigen::all, kept);
  rest.edges = instances.edges(Eigen::all, kept);
  rest.size_sigmas = instances.size_sigmas(kept);
  rest.T_object_geometry = instances.T_object_geometry(Eigen::all, kept);
  return rest;
}

}  // namespace armature
