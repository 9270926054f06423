// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/square_root_information.h"

#include <Eigen/Cholesky>

namespace armature {
namespace {

constexpr double kRounding = 1e-6;  // of the largest entry: what files with few digits lose

}  // namespace

std::optional<Matrix6d> SquareRootInformation(const Matrix6d& information) {
  const double slack = kRounding * information.cwiseAbs().maxCoeff();
  if ((information - information.transpose()).cwiseAbs().maxCoeff() > slack) return std::nullopt;
  // Omega = P^T L D L^T P; the permutation keeps it stable where Omega is singular.
  const Eigen::LDLT<Matrix6d> ldlt(information);
  const Vector6d D = ldlt.vectorD();
  if (D.minCoeff() < -slack) return std::nullopt;
  const Matrix6d permuted =
      Matrix6d(ldlt.matrixU()) * Matrix6d(ldlt.transpositionsP() * Matrix6d::Identity());
  return D.cwiseMax(0).cwiseSqrt().asDiagonal() * permuted;
}

}  // namespace armature
