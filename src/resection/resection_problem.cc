// SPDX-License-Identifier: BSD-3-Clause
#include "resection/resection_problem.h"

#include <cmath>

#include "geometry/rotation.h"

namespace armature {
namespace {

using Jacobian = Eigen::Map<Eigen::MatrixXd>;

constexpr double kNearestDepth = 0.05;  // metres; a point closer than this is treated as if it were there

// The unknowns unpacked, with what every term needs of them.
struct State {
  Eigen::Matrix3d R;
  Eigen::Vector3d T;
  Eigen::Map<const Eigen::VectorXd> lambda;
  Eigen::Matrix3d left_jacobian;

  State(const ResectionProblem& problem, const double* x) : lambda(x + 6, problem.Modes()) {
    const Eigen::Vector3d w(x[0], x[1], x[2]);
    R = ExpSO3(w) * problem.R0;
    T = problem.T0 + Eigen::Vector3d(x[3], x[4], x[5]);
    left_jacobian = LeftJacobianSO3(w);
  }
};

struct Robust {
  double value, slope;
};

Robust GemanMcClure(double r, double scale) {
  const double q = 1 / (1 + r * r / (scale * scale));
  const double root = std::sqrt(q);
  return {r * root, q * root};
}

// Fills a row for a residual whose derivative by the camera-frame point P = RX + T is `gradient`.
void FillPointRow(const State& state, const ShapePoint& point, const Eigen::Vector3d& RX,
                  const Eigen::RowVector3d& gradient, int row, Jacobian& J) {
  // d(exp(w) R0 X) = -[RX]x J_l dw, and -g^T [a]x = (a x g)^T
  J.block<1, 3>(row, 0) = RX.cross(gradient.transpose()).transpose() * state.left_jacobian;
  J.block<1, 3>(row, 3) = gradient;
  const Eigen::RowVector3d by_X = gradient * state.R;
  for (Eigen::Index j = 0; j < point.G.cols(); ++j) J(row, 6 + j) = by_X.dot(point.G.col(j));
}

double LineRow(const PointOnLineTerm& term, const Camera& camera, const State& state, int row, Jacobian* J) {
  Eigen::Vector3d X = term.point.X0;
  X.noalias() += term.point.G * state.lambda;
  const Eigen::Vector3d RX = state.R * X;
  const Eigen::Vector3d P = RX + state.T;
  const double inverse_z = 1 / std::max(P.z(), kNearestDepth);
  const double ax = term.line.x() * camera.fx, by = term.line.y() * camera.fy;
  const double x = P.x() * inverse_z, y = P.y() * inverse_z;
  const double distance =
      ax * x + by * y + term.line.x() * camera.cx + term.line.y() * camera.cy + term.line.z();
  if (term.only_positive && distance < 0) {
    if (J) J->row(row).setZero();
    return 0;
  }
  const Robust robust = GemanMcClure(term.weight * distance, term.loss_scale);
  if (J) {
    const double slope = robust.slope * term.weight * inverse_z;
    const double by_z = P.z() > kNearestDepth ? -(ax * x + by * y) : 0;
    FillPointRow(state, term.point, RX, slope * Eigen::RowVector3d(ax, by, by_z), row, *J);
  }
  return robust.value;
}

double PlaneRow(const PointOnPlaneTerm& term, const State& state, int row, Jacobian* J) {
  Eigen::Vector3d X = term.point.X0;
  X.noalias() += term.point.G * state.lambda;
  const Eigen::Vector3d RX = state.R * X;
  const double distance = term.normal.dot(RX + state.T) + term.offset;
  const Robust robust = GemanMcClure(term.weight * distance, term.loss_scale);
  if (J) FillPointRow(state, term.point, RX, robust.slope * term.weight * term.normal.transpose(), row, *J);
  return robust.value;
}

// R y_object = up
Eigen::Vector3d AxisRows(const State& state, const Eigen::Vector3d& up, double weight, int row, Jacobian* J) {
  const Eigen::Vector3d axis = state.R.col(1);
  if (J) J->block<3, 3>(row, 0) = -weight * Skew(axis) * state.left_jacobian;
  return weight * (axis - up);
}

// R n = up with n = D1 x D2 / |D1 x D2|
Eigen::Vector3d BaseRows(const ResectionProblem& problem, const State& state, int row, Jacobian* J) {
  const auto [e1, e2] = problem.model->spec.base_edges;
  const ShapePoint a = PointOnEdge(*problem.model, e1, 0.5), b = PointOnEdge(*problem.model, e1, -0.5);
  const ShapePoint c = PointOnEdge(*problem.model, e2, 0.5), d = PointOnEdge(*problem.model, e2, -0.5);
  const Eigen::Vector3d D1 = a.X0 - b.X0 + (a.G - b.G) * state.lambda;
  const Eigen::Vector3d D2 = c.X0 - d.X0 + (c.G - d.G) * state.lambda;
  const Eigen::Vector3d cross = D1.cross(D2);
  const double norm = std::max(cross.norm(), 1e-9);
  const Eigen::Vector3d normal = cross / norm;
  const Eigen::Vector3d Rn = state.R * normal;
  if (J) {
    J->block<3, 3>(row, 0) = -problem.up_weight * Skew(Rn) * state.left_jacobian;
    const Eigen::Matrix3d along = (Eigen::Matrix3d::Identity() - normal * normal.transpose()) / norm;
    for (int j = 0; j < problem.Modes(); ++j) {
      const Eigen::Vector3d by_mode = Eigen::Vector3d(a.G.col(j) - b.G.col(j)).cross(D2) +
                                      D1.cross(Eigen::Vector3d(c.G.col(j) - d.G.col(j)));
      J->block<3, 1>(row, 6 + j) = problem.up_weight * state.R * (along * by_mode);
    }
  }
  return problem.up_weight * (Rn - problem.up_camera);
}

// (R M1 + T) x (R M2 + T) = Y exactly as printed: not a normal, and not free of scale; kept for the
// comparison.
Eigen::Vector3d PrintedRows(const ResectionProblem& problem, const State& state, int row, Jacobian* J) {
  const auto [e1, e2] = problem.model->spec.base_edges;
  const ShapePoint m1 = PointOnEdge(*problem.model, e1, 0), m2 = PointOnEdge(*problem.model, e2, 0);
  const Eigen::Vector3d RX1 = state.R * (m1.X0 + m1.G * state.lambda);
  const Eigen::Vector3d RX2 = state.R * (m2.X0 + m2.G * state.lambda);
  const Eigen::Vector3d P1 = RX1 + state.T, P2 = RX2 + state.T;
  if (J) {
    // d(P1 x P2) = -[P2]x dP1 + [P1]x dP2
    const Eigen::Matrix3d by_P1 = -problem.up_weight * Skew(P2), by_P2 = problem.up_weight * Skew(P1);
    J->block<3, 3>(row, 0) = -(by_P1 * Skew(RX1) + by_P2 * Skew(RX2)) * state.left_jacobian;
    J->block<3, 3>(row, 3) = by_P1 + by_P2;
    J->block(row, 6, 3, problem.Modes()) = by_P1 * state.R * m1.G + by_P2 * state.R * m2.G;
  }
  return problem.up_weight * (P1.cross(P2) - problem.up_camera);
}

Eigen::Vector3d NormalRows(const ResectionProblem& problem, const State& state, int row, Jacobian* J) {
  if (J) J->middleRows<3>(row).setZero();
  switch (problem.normal_term) {
    case NormalTerm::kNone:
      return Eigen::Vector3d::Zero();
    case NormalTerm::kAxis:
      return AxisRows(state, problem.up_camera, problem.up_weight, row, J);
    case NormalTerm::kBase:
      return BaseRows(problem, state, row, J);
    case NormalTerm::kPrinted:
      return PrintedRows(problem, state, row, J);
  }
  return Eigen::Vector3d::Zero();
}

// r = L^T (z - z_expected), scaled as a whole by a = 1 / sqrt(1 + |r|^2 / c^2).
void MemoryRows(const ResectionProblem& problem, const State& state, int row, double* residuals,
                Jacobian* J) {
  const ObjectMemory& memory = *problem.memory;
  const Eigen::VectorXd r = memory.sqrt_information * memory.Difference(state.R, state.T, state.lambda);
  const double c2 = problem.memory_loss_scale * problem.memory_loss_scale;
  const double a = 1 / std::sqrt(1 + r.squaredNorm() / c2);
  Eigen::Map<Eigen::VectorXd>(residuals + row, r.size()) = a * r;
  if (!J) return;
  Eigen::MatrixXd by_x = Eigen::MatrixXd::Zero(r.size(), problem.NumParameters());
  // d(R e_z) = -[R e_z]x J_l dw, and g^T (-[v]x) = (v x g)^T
  const Eigen::Vector3d front = state.R.col(2);
  by_x.leftCols<3>().noalias() =
      memory.sqrt_information.col(3) * (front.cross(memory.AheadOfFront()).transpose() * state.left_jacobian);
  by_x.middleCols<3>(3) = memory.sqrt_information.leftCols<3>();
  by_x.rightCols(problem.Modes()) = memory.sqrt_information.rightCols(problem.Modes());
  J->middleRows(row, r.size()) = a * by_x - (a * a * a / c2) * r * (r.transpose() * by_x);
}

void RegulariserRows(const ResectionProblem& problem, const State& state, int row, double* residuals,
                     Jacobian* J) {
  Eigen::Map<Eigen::VectorXd>(residuals + row, problem.Modes()) = problem.shape_weight * state.lambda;
  if (!J) return;
  J->middleRows(row, problem.Modes()).setZero();
  J->middleRows(row, problem.Modes()).rightCols(problem.Modes()).diagonal().setConstant(problem.shape_weight);
}

}  // namespace

ShapePoint PointOnEdge(const CategoryModel& model, int edge, double s) {
  ShapePoint point;
  const auto M = model.basis.middleRows<3>(6 * edge), D = model.basis.middleRows<3>(6 * edge + 3);
  point.X0 = model.mean.segment<3>(6 * edge) + s * model.mean.segment<3>(6 * edge + 3);
  point.G = (M + s * D) * model.standard_deviations.asDiagonal();
  return point;
}

ShapePoint LowestPoint(const CategoryModel& model, const Eigen::VectorXd& coefficients) {
  const Wireframe wireframe = WireframeFromCoefficients(model, coefficients);
  EdgeEnd lowest;
  double lowest_y = 1e9;
  for (int edge = 0; edge < wireframe.edges(); ++edge) {
    for (int end = 0; end < 2; ++end) {
      if (const double y = wireframe.End(edge, end).y(); y < lowest_y) {
        lowest_y = y;
        lowest = {edge, end};
      }
    }
  }
  return PointOnEdge(model, lowest.edge, lowest.end - 0.5);
}

bool ResectionProblem::operator()(const double* parameters, double* residuals, double* jacobian) const {
  const State state(*this, parameters);
  Jacobian J(jacobian, jacobian ? NumResiduals() : 0, jacobian ? NumParameters() : 0);
  Jacobian* J_or_null = jacobian ? &J : nullptr;
  int row = 0;
  for (const PointOnLineTerm& term : line_terms) {
    residuals[row] = LineRow(term, *camera, state, row, J_or_null);
    ++row;
  }
  for (const PointOnPlaneTerm& term : plane_terms) {
    residuals[row] = PlaneRow(term, state, row, J_or_null);
    ++row;
  }
  Eigen::Map<Eigen::Vector3d>(residuals + row) = NormalRows(*this, state, row, J_or_null);
  row += 3;
  if (memory) {
    MemoryRows(*this, state, row, residuals, J_or_null);
  } else {
    RegulariserRows(*this, state, row, residuals, J_or_null);
  }
  if (jacobian) {
    if (!pose_is_free) J.leftCols<6>().setZero();
    if (!shape_is_free) J.rightCols(Modes()).setZero();
  }
  return true;
}

}  // namespace armature
