// SPDX-License-Identifier: BSD-3-Clause
#include "category/normalise.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"

namespace armature {
namespace {

constexpr double kSmallestMeasure = 1e-9;

struct Bounds {
  Eigen::Vector3d min, max;
};

Bounds ComputeBounds(const Wireframe& wireframe) {
  const Eigen::Matrix3Xd half = wireframe.directions.cwiseAbs() / 2;
  return {(wireframe.midpoints - half).rowwise().minCoeff(),
          (wireframe.midpoints + half).rowwise().maxCoeff()};
}

// The name with its first `left` made `right`, or the other way round; the same name if it has neither.
std::string MirroredName(std::string name) {
  if (const size_t at = name.find("left"); at != std::string::npos) return name.replace(at, 4, "right");
  if (const size_t at = name.find("right"); at != std::string::npos) return name.replace(at, 5, "left");
  return name;
}

}  // namespace

Eigen::Vector3d BoundingBoxCenter(const Wireframe& wireframe) {
  const Bounds bounds = ComputeBounds(wireframe);
  return (bounds.min + bounds.max) / 2;
}

double Measure(const MetricReference& reference, const Wireframe& wireframe) {
  const double ground = ComputeBounds(wireframe).min.y();
  double sum = 0;
  for (const int edge : reference.edges) {
    sum += reference.measure == MetricReference::Measure::kLength ? wireframe.directions.col(edge).norm()
                                                                  : wireframe.midpoints(1, edge) - ground;
  }
  return sum / static_cast<double>(reference.edges.size());
}

Wireframe Centred(const Wireframe& wireframe) {
  return {wireframe.midpoints.colwise() - BoundingBoxCenter(wireframe), wireframe.directions};
}

Wireframe Normalised(const MetricReference& reference, const Wireframe& wireframe) {
  const double measure = Measure(reference, wireframe);
  if (!(measure > kSmallestMeasure)) {
    throw InputError(
        fmt::format("its metric reference measures {:g}; it cannot be scaled to {:g} m, check the "
                    "reference's edges and that y is up",
                    measure, reference.metres));
  }
  const double scale = reference.metres / measure;
  return Centred({scale * wireframe.midpoints, scale * wireframe.directions});
}

Wireframe Mirrored(const CategorySpec& spec, const Wireframe& wireframe) {
  const Eigen::Vector3d flip(-1, 1, 1);
  Wireframe mirrored = wireframe;
  for (int i = 0; i < wireframe.edges(); ++i) {
    const std::string& name = spec.edge_names[static_cast<size_t>(i)];
    const std::string partner = MirroredName(name);
    const auto found = std::find(spec.edge_names.begin(), spec.edge_names.end(), partner);
    if (found == spec.edge_names.end()) {
      throw InputError(
          fmt::format("category {}: edge '{}' has no mirror image '{}'; set training.mirrored to false",
                      spec.name, name, partner));
    }
    const double sense = partner == name ? -1 : 1;
    const Eigen::Index to = found - spec.edge_names.begin();
    mirrored.midpoints.col(to) = flip.cwiseProduct(wireframe.midpoints.col(i));
    mirrored.directions.col(to) = sense * flip.cwiseProduct(wireframe.directions.col(i));
  }
  return mirrored;
}

}  // namespace armature
