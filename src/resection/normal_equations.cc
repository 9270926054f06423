// SPDX-License-Identifier: BSD-3-Clause
#include "resection/normal_equations.h"

#include "geometry/rotation.h"

namespace armature {
namespace {

template <int kModes>
void AddPointRow(const ResectionState& state, const ShapePoint& point, const PointRow& values,
                 NormalEquations<kModes>& equations) {
  // A hidden side of the box that is reached: neither cost nor derivative. One that is just touched has both.
  if (values.gradient.isZero(0)) return;
  typename NormalEquations<kModes>::Vector row(equations.gradient.size());
  row.template head<3>() = values.ByRotation();
  row.template segment<3>(3) = values.gradient;
  const Eigen::Vector3d by_X = values.ByObjectPoint(state);
  for (Eigen::Index j = 0; j < point.G.cols(); ++j) row(6 + j) = by_X.dot(point.G.col(j));
  equations.Add(row, values.residual);
}

template <int kModes>
void AddNormal(const ResectionProblem& problem, const ResectionState& state,
               NormalEquations<kModes>& equations) {
  if (problem.normal_term == NormalTerm::kNone) return;
  const NormalRows rows = MakeNormalRows(problem, state);
  for (int i = 0; i < 3; ++i) equations.Add(rows.by_unknowns.row(i).transpose(), rows.residuals(i));
}

template <int kModes>
void AddRegulariser(const ResectionProblem& problem, const ResectionState& state,
                    NormalEquations<kModes>& equations) {
  const double information = problem.shape_weight * problem.shape_weight;
  equations.information.diagonal().tail(problem.Modes()).array() += information;
  equations.gradient.tail(problem.Modes()) += information * state.lambda;
  equations.cost += information * state.lambda.squaredNorm() / 2;
}

// With z - z_expected = d, its information I = L L^T, the rows r = L^T d and M = dr/dx: the scaled rows a r,
// a = 1/sqrt(1 + r^T r / c^2), have the derivative a M - a^3/c^2 r r^T M, so that
//   J^T (a r) = a^4 M^T r,   J^T J = a^2 M^T M - (a^4/c^2) (1 + a^2) (M^T r)(M^T r)^T,
// where M^T r and M^T M are rows and blocks of I d and I.
template <int kModes>
void AddTrackPrior(const ResectionProblem& problem, const ResectionState& state,
                   NormalEquations<kModes>& equations) {
  using Vector = typename NormalEquations<kModes>::Vector;
  const TrackPrior& prior = *problem.track_prior;
  const Eigen::Index modes = problem.Modes();
  const auto difference = prior.Difference(state.R, state.T, state.lambda);
  const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4 + kMaxModes, 1> push = prior.information * difference;
  const double squared = difference.dot(push);
  const double a2 = std::pow(GroupWeight(squared, problem.memory_loss_scale), 2);
  const double c2 = problem.memory_loss_scale * problem.memory_loss_scale;
  const Eigen::Vector3d by_rotation = YawByRotation(prior, state);
  // z is (T, yaw, lambda), x is (w, v, lambda).
  Vector m(6 + modes);
  m << by_rotation * push(3), push.template head<3>(), push.tail(modes);
  typename NormalEquations<kModes>::Matrix& H = equations.information;
  const Eigen::MatrixXd& I = prior.information;
  H.template topLeftCorner<3, 3>() += a2 * I(3, 3) * by_rotation * by_rotation.transpose();
  H.template block<3, 3>(3, 0) += a2 * I.col(3).template head<3>() * by_rotation.transpose();
  H.bottomLeftCorner(modes, 3) += a2 * I.col(3).tail(modes) * by_rotation.transpose();
  H.template block<3, 3>(3, 3) += a2 * I.topLeftCorner<3, 3>();
  H.block(6, 3, modes, 3) += a2 * I.bottomLeftCorner(modes, 3);
  H.bottomRightCorner(modes, modes) += a2 * I.bottomRightCorner(modes, modes);
  H.noalias() -= (a2 * a2 / c2 * (1 + a2) * m) * m.transpose();
  equations.gradient += a2 * a2 * m;
  equations.cost += a2 * squared / 2;
}

}  // namespace

template <int kModes>
NormalEquations<kModes> Linearise(const ResectionProblem& problem, const double* x) {
  const ResectionState state(problem, x);
  NormalEquations<kModes> equations(problem.NumParameters());
  for (const PointOnLineTerm& term : problem.line_terms) {
    AddPointRow(state, term.point, LineRow(term, *problem.camera, state), equations);
  }
  for (const PointOnPlaneTerm& term : problem.plane_terms) {
    AddPointRow(state, term.point, PlaneRow(term, state), equations);
  }
  AddNormal(problem, state, equations);
  if (problem.track_prior) {
    AddTrackPrior(problem, state, equations);
  } else {
    AddRegulariser(problem, state, equations);
  }
  equations.Complete(LeftJacobianSO3(Eigen::Vector3d(x[0], x[1], x[2])));
  return equations;
}

template NormalEquations<7> Linearise<7>(const ResectionProblem&, const double*);
template NormalEquations<Eigen::Dynamic> Linearise<Eigen::Dynamic>(const ResectionProblem&, const double*);

}  // namespace armature
