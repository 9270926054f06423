// SPDX-License-Identifier: BSD-3-Clause
// The least-squares problem of paper 3.4: pose and shape of one object from its matched lines.
//
// Unknowns x = (w, v, lambda): R = exp(w) R0, T = T0 + v, shape = mean + basis * (deviations .* lambda).
//
// The paper constrains the plane through the camera and a segment (normal N) twice, eqs. 17
// and 18:
//   N . (R M + T) = 0   and   N . (R D) = 0.
// Any point X = M + s D of the edge then satisfies N . (R X + T) = (N . (R M + T)) + s (N . R D) = 0. We take
// the two points whose images lie nearest to the segment's ends and divide by the depth: with N = K^T l, l
// the segment's line in pixels, l = (a, b, c), a^2 + b^2 = 1, both residuals become the distance in pixels
//   r = l . pi(R X + T).
// It is the same pair of constraints, mixed so that they are in pixels and a short segment says little about
// the far end of a long edge.
//
// Robust loss: Geman-McClure, applied to the residual itself, r -> r / sqrt(1 + (r/c)^2), so that half the
// squared norm of what the solver sees is the robust cost and its derivative is exact.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "association/object_view.h"
#include "base/enum_names.h"
#include "category/category_model.h"
#include "geometry/camera.h"

namespace armature {

// Columns are kept in place, without a heap allocation for each point.
using ShapeJacobian = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, kMaxModes>;

// A point of the object, as a function of its shape: X0 + G * lambda, object frame, metres.
struct ShapePoint {
  Eigen::Vector3d X0;
  ShapeJacobian G;  // 3 x B
};

// The point M + s D of an edge, s in [-1/2, 1/2] between the edge's ends.
ShapePoint PointOnEdge(const CategoryModel& model, int edge, double s);

// The end of an edge that is lowest for these coefficients.
ShapePoint LowestPoint(const CategoryModel& model, const Eigen::VectorXd& coefficients);

// A point that should be seen on an image line: residual = weight * robust(l . pi(R X + T)).
struct PointOnLineTerm {
  ShapePoint point;
  Eigen::Vector3d line;   // a^2 + b^2 = 1, pixels
  double weight = 1;      // 1 / pixels
  double loss_scale = 3;  // of the weighted residual
  bool only_positive =
      false;  // no cost where the signed distance is negative (a side that may be hidden or cut)
};

// A point that should lie on a plane of the camera frame: residual = weight * robust(normal . (R X + T) +
// offset).
struct PointOnPlaneTerm {
  ShapePoint point;
  Eigen::Vector3d normal;  // unit, camera frame
  double offset = 0;       // metres
  double weight = 1;       // 1 / metres
  double loss_scale = 3;
};

enum class NormalTerm {
  kNone,
  kAxis,  // the object's y axis is up (models stand upright in their frame, so this holds whatever the seat's
          // slope)
  kBase,  // the base's normal R D1 x R D2, normalised, is up
  kPrinted,  // (R M1 + T) x (R M2 + T) = Y, as the paper prints eq. 20
};

template <>
struct EnumNames<NormalTerm> {
  static constexpr NamedValue<NormalTerm> kTable[] = {{NormalTerm::kNone, "none"},
                                                      {NormalTerm::kAxis, "axis"},
                                                      {NormalTerm::kBase, "base"},
                                                      {NormalTerm::kPrinted, "printed"}};
};

struct ResectionProblem {
  // For ceres::TinySolver.
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = Eigen::Dynamic };

  Eigen::Matrix3d R0 = Eigen::Matrix3d::Identity();
  Eigen::Vector3d T0 = Eigen::Vector3d::Zero();
  const Camera* camera = nullptr;
  const CategoryModel* model = nullptr;
  std::vector<PointOnLineTerm> line_terms;
  std::vector<PointOnPlaneTerm> plane_terms;
  NormalTerm normal_term = NormalTerm::kAxis;
  Eigen::Vector3d up_camera{0, -1, 0};  // unit
  double up_weight = 0;                 // 1 / radians
  double shape_weight = 1;              // of each coefficient in standard deviations
  // What earlier frames say, instead of the shape's regulariser; none: null. Its 4 + B whitened residuals
  // share one robust loss: the memory is right or wrong as a whole.
  const TrackPrior* track_prior = nullptr;
  double memory_loss_scale = 5;  // standard deviations
  // Which unknowns may move; the paper alternates between pose and shape.
  bool pose_is_free = true;
  bool shape_is_free = true;

  int Modes() const { return static_cast<int>(model->modes()); }
  int PriorRows() const { return Modes() + (track_prior ? 4 : 0); }  // regulariser or memory
  int NumParameters() const { return 6 + Modes(); }
  int NumResiduals() const {
    return static_cast<int>(line_terms.size() + plane_terms.size()) + 3 + PriorRows();
  }
  // parameters: 6+B; residuals: NumResiduals(); jacobian: column-major NumResiduals() x (6+B) or null.
  bool operator()(const double* parameters, double* residuals, double* jacobian) const;
};

}  // namespace armature
