// SPDX-License-Identifier: BSD-3-Clause
#include "resection/resection_problem.h"

#include "resection/resection_rows.h"

namespace armature {
namespace {

using Jacobian = Eigen::Map<Eigen::MatrixXd>;

// By dw for now, see ResectionState.
void FillPointRow(const ResectionState& state, const ShapePoint& point, const PointRow& values, int row,
                  Jacobian& J) {
  J.block<1, 3>(row, 0) = values.ByRotation().transpose();
  J.block<1, 3>(row, 3) = values.gradient.transpose();
  J.row(row).tail(point.G.cols()) = values.ByObjectPoint(state).transpose() * point.G;
}

// r = L^T (z - z_expected), scaled as a whole.
void FillTrackPriorRows(const ResectionProblem& problem, const ResectionState& state, int row,
                        double* residuals, Jacobian* J) {
  const TrackPrior& prior = *problem.track_prior;
  const Eigen::VectorXd r = prior.sqrt_information * prior.Difference(state.R, state.T, state.lambda);
  const double a = GroupWeight(r.squaredNorm(), problem.memory_loss_scale);
  Eigen::Map<Eigen::VectorXd>(residuals + row, r.size()) = a * r;
  if (!J) return;
  Eigen::MatrixXd by_x = Eigen::MatrixXd::Zero(r.size(), problem.NumParameters());
  by_x.leftCols<3>() = prior.sqrt_information.col(3) * YawByRotation(prior, state).transpose();
  by_x.middleCols<3>(3) = prior.sqrt_information.leftCols<3>();
  by_x.rightCols(problem.Modes()) = prior.sqrt_information.rightCols(problem.Modes());
  const double c2 = problem.memory_loss_scale * problem.memory_loss_scale;
  J->middleRows(row, r.size()) = a * by_x - (a * a * a / c2) * r * (r.transpose() * by_x);
}

void FillRegulariserRows(const ResectionProblem& problem, const ResectionState& state, int row,
                         double* residuals, Jacobian* J) {
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
  const ResectionState state(*this, parameters);
  Jacobian J(jacobian, jacobian ? NumResiduals() : 0, jacobian ? NumParameters() : 0);
  Jacobian* J_or_null = jacobian ? &J : nullptr;
  int row = 0;
  const auto add = [&](const ShapePoint& point, const PointRow& values) {
    residuals[row] = values.residual;
    if (jacobian) FillPointRow(state, point, values, row, J);
    ++row;
  };
  for (const PointOnLineTerm& term : line_terms) add(term.point, LineRow(term, *camera, state));
  for (const PointOnPlaneTerm& term : plane_terms) add(term.point, PlaneRow(term, state));
  const NormalRows normal = MakeNormalRows(*this, state);
  Eigen::Map<Eigen::Vector3d>(residuals + row) = normal.residuals;
  if (jacobian) J.middleRows<3>(row) = normal.by_unknowns;
  row += 3;
  if (track_prior) {
    FillTrackPriorRows(*this, state, row, residuals, J_or_null);
  } else {
    FillRegulariserRows(*this, state, row, residuals, J_or_null);
  }
  if (jacobian) {
    const Eigen::Vector3d w(parameters[0], parameters[1], parameters[2]);
    J.leftCols<3>() *= LeftJacobianSO3(w);
    if (!pose_is_free) J.leftCols<6>().setZero();
    if (!shape_is_free) J.rightCols(Modes()).setZero();
  }
  return true;
}

}  // namespace armature
