// SPDX-License-Identifier: BSD-3-Clause
#include "resection/resection_rows.h"

#include <algorithm>
#include <cmath>

namespace armature {
namespace {

constexpr double kNearestDepth = 0.05;  // metres; a point closer than this is treated as if it were there

struct Robust {
  double value, slope;
};

Robust GemanMcClure(double r, double scale) {
  const double q = 1 / (1 + r * r / (scale * scale));
  const double root = std::sqrt(q);
  return {r * root, q * root};
}

Eigen::Vector3d Rotated(const ShapePoint& point, const ResectionState& state) {
  Eigen::Vector3d X = point.X0;
  for (Eigen::Index j = 0; j < point.G.cols(); ++j) X += point.G.col(j) * state.lambda(j);
  return state.R * X;
}

// R y_object = up
void AddAxis(const ResectionState& state, const Eigen::Vector3d& up, double weight, NormalRows& rows) {
  const Eigen::Vector3d axis = state.R.col(1);
  rows.residuals = weight * (axis - up);
  rows.by_unknowns.leftCols<3>() = -weight * Skew(axis);
}

// R n = up with n = D1 x D2 / |D1 x D2|
void AddBase(const ResectionProblem& problem, const ResectionState& state, NormalRows& rows) {
  const auto [e1, e2] = problem.model->spec.base_edges;
  const ShapePoint a = PointOnEdge(*problem.model, e1, 0.5), b = PointOnEdge(*problem.model, e1, -0.5);
  const ShapePoint c = PointOnEdge(*problem.model, e2, 0.5), d = PointOnEdge(*problem.model, e2, -0.5);
  const Eigen::Vector3d D1 = a.X0 - b.X0 + (a.G - b.G) * state.lambda;
  const Eigen::Vector3d D2 = c.X0 - d.X0 + (c.G - d.G) * state.lambda;
  const Eigen::Vector3d cross = D1.cross(D2);
  const double norm = std::max(cross.norm(), 1e-9);
  const Eigen::Vector3d normal = cross / norm;
  const Eigen::Vector3d Rn = state.R * normal;
  rows.residuals = problem.up_weight * (Rn - problem.up_camera);
  rows.by_unknowns.leftCols<3>() = -problem.up_weight * Skew(Rn);
  const Eigen::Matrix3d along = (Eigen::Matrix3d::Identity() - normal * normal.transpose()) / norm;
  for (int j = 0; j < problem.Modes(); ++j) {
    const Eigen::Vector3d by_mode = Eigen::Vector3d(a.G.col(j) - b.G.col(j)).cross(D2) +
                                    D1.cross(Eigen::Vector3d(c.G.col(j) - d.G.col(j)));
    rows.by_unknowns.col(6 + j) = problem.up_weight * state.R * (along * by_mode);
  }
}

// (R M1 + T) x (R M2 + T) = Y exactly as printed: not a normal, and not free of scale; kept for the
// comparison.
void AddPrinted(const ResectionProblem& problem, const ResectionState& state, NormalRows& rows) {
  const auto [e1, e2] = problem.model->spec.base_edges;
  const ShapePoint m1 = PointOnEdge(*problem.model, e1, 0), m2 = PointOnEdge(*problem.model, e2, 0);
  const Eigen::Vector3d RX1 = Rotated(m1, state), RX2 = Rotated(m2, state);
  const Eigen::Vector3d P1 = RX1 + state.T, P2 = RX2 + state.T;
  rows.residuals = problem.up_weight * (P1.cross(P2) - problem.up_camera);
  // d(P1 x P2) = -[P2]x dP1 + [P1]x dP2
  const Eigen::Matrix3d by_P1 = -problem.up_weight * Skew(P2), by_P2 = problem.up_weight * Skew(P1);
  rows.by_unknowns.leftCols<3>() = -(by_P1 * Skew(RX1) + by_P2 * Skew(RX2));
  rows.by_unknowns.middleCols<3>(3) = by_P1 + by_P2;
  rows.by_unknowns.rightCols(problem.Modes()) = by_P1 * state.R * m1.G + by_P2 * state.R * m2.G;
}

}  // namespace

PointRow LineRow(const PointOnLineTerm& term, const Camera& camera, const ResectionState& state) {
  PointRow row;
  row.RX = Rotated(term.point, state);
  const Eigen::Vector3d P = row.RX + state.T;
  const double inverse_z = 1 / std::max(P.z(), kNearestDepth);
  const double ax = term.line.x() * camera.fx, by = term.line.y() * camera.fy;
  const double x = P.x() * inverse_z, y = P.y() * inverse_z;
  const double distance =
      ax * x + by * y + term.line.x() * camera.cx + term.line.y() * camera.cy + term.line.z();
  if (term.only_positive && distance < 0) return row;
  const Robust robust = GemanMcClure(term.weight * distance, term.loss_scale);
  row.residual = robust.value;
  const double by_z = P.z() > kNearestDepth ? -(ax * x + by * y) : 0;
  row.gradient = robust.slope * term.weight * inverse_z * Eigen::Vector3d(ax, by, by_z);
  return row;
}

PointRow PlaneRow(const PointOnPlaneTerm& term, const ResectionState& state) {
  PointRow row;
  row.RX = Rotated(term.point, state);
  const double distance = term.normal.dot(row.RX + state.T) + term.offset;
  const Robust robust = GemanMcClure(term.weight * distance, term.loss_scale);
  row.residual = robust.value;
  row.gradient = robust.slope * term.weight * term.normal;
  return row;
}

NormalRows MakeNormalRows(const ResectionProblem& problem, const ResectionState& state) {
  NormalRows rows;
  rows.by_unknowns.setZero(3, problem.NumParameters());
  if (problem.normal_term == NormalTerm::kAxis) AddAxis(state, problem.up_camera, problem.up_weight, rows);
  if (problem.normal_term == NormalTerm::kBase) AddBase(problem, state, rows);
  if (problem.normal_term == NormalTerm::kPrinted) AddPrinted(problem, state, rows);
  return rows;
}

Eigen::Vector3d YawByRotation(const TrackPrior& prior, const ResectionState& state) {
  // d(R e_z) = -[R e_z]x dw, and g^T (-[v]x) = (v x g)^T
  return state.R.col(2).cross(prior.AheadOfFront());
}

double GroupWeight(double squared, double loss_scale) {
  return 1 / std::sqrt(1 + squared / (loss_scale * loss_scale));
}

}  // namespace armature
