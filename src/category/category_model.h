// SPDX-License-Identifier: BSD-3-Clause
// Line-based category models (paper 3.2): a category's edges, their mean and the directions in which they
// vary.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace armature {

constexpr int kMaxModes = 16;        // of a category's shape
constexpr int kMaxFaceCorners = 16;  // of one of its faces

// The edges of one object as columns, in the object frame (y up, front +z, origin at the centre of the
// bounding box), metres. The paper's X = <L_1 ... L_m>, L_i = <M_i, D_i>; here |D| is the edge's length, so
// its ends are M -+ D/2.
struct Wireframe {
  Eigen::Matrix3Xd midpoints;   // 3 x m, M
  Eigen::Matrix3Xd directions;  // 3 x m, D

  int edges() const { return static_cast<int>(midpoints.cols()); }
  // end 0: M - D/2, end 1: M + D/2
  Eigen::Vector3d End(int edge, int end) const {
    return midpoints.col(edge) + (end - 0.5) * directions.col(edge);
  }
};

struct EdgeEnd {
  int edge = 0;  // index of the edge
  int end = 0;   // 0: M - D/2, 1: M + D/2
};

// A flat, opaque face spanned by ends of edges, in order around it; it hides the edges behind it.
struct Face {
  std::string name;
  std::vector<EdgeEnd> corners;  // 3 to kMaxFaceCorners
};

// A horizontal board - a table's top, a seat - that is annotated along its upper side. What is seen of the
// sides that face the camera is mostly the lower outline, for there the bright board ends before the dark
// below it.
struct SlabOutline {
  std::vector<int> edges;  // around it
  double drop = 0;  // metres by which lines of the near sides lie below the edge, on average; they scatter
                    // by about as much
};

// How annotated models are brought to metres: a measure of the wireframe that has a known length in the real
// world.
struct MetricReference {
  enum class Measure {
    kHeightAboveGround,  // mean height of the named edges' midpoints above the wireframe's lowest end
    kLength,             // mean length of the named edges
  };
  Measure measure = Measure::kHeightAboveGround;
  std::vector<int> edges;
  double metres = 1.0;
};

// What a category is, before anything is learnt about its shape: the content of a category's specification.
struct CategorySpec {
  std::string name;
  std::vector<std::string> edge_names;  // m
  std::array<int, 2> base_edges{0,
                                1};  // adjacent edges of the base with D1 x D2 pointing up (the normal term)
  std::vector<Face> faces;
  int symmetry_order = 1;        // looks the same after each n-th of a turn about y: 1 none, 2 half a turn
  bool stands_on_floor = false;  // its lowest point touches the floor (a laptop's need not)
  Eigen::Vector3d padding{0, 0, 0};  // metres: how far the real object reaches beyond its wireframe, on both
                                     // sides along each axis: half a leg's thickness, for example
  std::optional<SlabOutline> slab;
  MetricReference reference;
  double size_sigma =
      0.07;  // standard deviation of the logarithm of how much larger one is than the reference
  int dictionary_size = 4;  // 3-5 in the paper

  int edges() const { return static_cast<int>(edge_names.size()); }
};

// Shape = mean + basis * (standard_deviations .* coefficients): coefficients are in standard deviations, so
// their squared norm is the squared Mahalanobis distance from the mean. Rows are M_1 D_1 M_2 D_2 ..., three
// each.
struct CategoryModel {
  CategorySpec spec;
  std::string source;                       // what it was learnt from, and under which licence
  int training_models = 0;                  // how many annotated models
  Eigen::VectorXd mean;                     // 6m
  Eigen::MatrixXd basis;                    // 6m x B, orthonormal columns, by falling variance
  Eigen::VectorXd standard_deviations;      // B, metres
  double total_variance = 0;                // of all 6m modes, metres^2
  std::vector<Eigen::VectorXd> dictionary;  // coefficients of the representative models, B each

  int modes() const { return static_cast<int>(basis.cols()); }
};

// The paper's X as one vector (M_1 D_1 M_2 D_2 ...) and back.
Eigen::VectorXd ShapeVector(const Wireframe& wireframe);
Wireframe WireframeFromVector(const Eigen::VectorXd& shape);

// Wireframe of the given coefficients (standard deviations); fewer than B coefficients leave the later modes
// at 0.
Wireframe WireframeFromCoefficients(const CategoryModel& model, const Eigen::VectorXd& coefficients);

// Coefficients of the model's shape nearest to the wireframe (orthogonal projection on the basis), in
// standard deviations.
Eigen::VectorXd CoefficientsFromWireframe(const CategoryModel& model, const Wireframe& wireframe);

// Of what coefficients depend on: edges, mean, basis, deviations. Tells whether coefficients are of this
// model.
std::uint64_t ModelChecksum(const CategoryModel& model);

// Size of the wireframe's bounding box along x, y, z, metres.
Eigen::Vector3d BoundingBoxSize(const Wireframe& wireframe);

}  // namespace armature
