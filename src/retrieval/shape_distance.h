// SPDX-License-Identifier: BSD-3-Clause
// Distances between an estimated shape and the instances of a library.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "base/enum_names.h"
#include "mapping/shape_evidence.h"
#include "retrieval/instance_index.h"
#include "retrieval/instance_library.h"

namespace armature {

// What is known of an object's shape.
struct ShapeQuery {
  Eigen::VectorXd coefficients;           // B, standard deviations
  Eigen::Vector3d size{0, 0, 0};          // of the bounding box, metres
  std::optional<ShapeEvidence> evidence;  // of the images alone; none: not known
};

enum class FeatureSpace {
  kWhitened,  // coefficients in standard deviations, each mode counts the same
  kRaw,       // times the modes' deviations, metres, so that a distance is that of the shape vectors
};

template <>
struct EnumNames<FeatureSpace> {
  static constexpr NamedValue<FeatureSpace> kTable[] = {{FeatureSpace::kWhitened, "whitened"},
                                                        {FeatureSpace::kRaw, "raw"}};
};

// The space in which neighbours are near (paper 4.2: that of the principal coefficients).
struct FeatureOptions {
  FeatureSpace space = FeatureSpace::kWhitened;
  int modes = 0;            // only the first so many; 0: all
  bool with_size = false;   // the box's size as three more dimensions
  double size_sigma = 0.1;  // metres of size that count as much as one deviation (whitened only)
};

// A column an instance.
Eigen::MatrixXf Features(const CategoryInstances& instances, const Eigen::VectorXd& standard_deviations,
                         const FeatureOptions& options);
Eigen::VectorXf ComputeFeatures(const ShapeQuery& query, const Eigen::VectorXd& standard_deviations,
                                const FeatureOptions& options);

// The k instances that the evidence holds for the likeliest, likeliest first, equally likely ones by rising
// instance: distance^2 = (x - m)^T C^-1 (x - m) with the evidence's mean m and C its covariance plus sigma^2
// I, what the evidence does not know of itself (wrong matches, a wireframe that is not the object). A leg
// that was never seen does not count: the directions without information are flat. In standard deviations, of
// directions that are known. An exact scan: each query has a metric of its own. `modes` as in FeatureOptions:
// later ones are unknown, and marginalised.
std::vector<Neighbour> Likeliest(const CategoryInstances& instances, const ShapeEvidence& evidence,
                                 double sigma, int modes, int k);

}  // namespace armature
