// SPDX-License-Identifier: BSD-3-Clause
// The normal equations of a resection, collected row by row: J^T J and J^T r without J. Sizes are known to
// the compiler for the usual number of modes, so that nothing is allocated and loops unroll.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "resection/resection_problem.h"
#include "resection/resection_rows.h"

namespace armature {

// kModes: B, or Eigen::Dynamic for any number up to kMaxModes.
template <int kModes>
struct NormalEquations {
  static constexpr int kUnknowns = kModes == Eigen::Dynamic ? Eigen::Dynamic : 6 + kModes;
  static constexpr int kMost = kModes == Eigen::Dynamic ? 6 + kMaxModes : 6 + kModes;
  using Matrix = Eigen::Matrix<double, kUnknowns, kUnknowns, Eigen::ColMajor, kMost, kMost>;
  using Vector = Eigen::Matrix<double, kUnknowns, 1, Eigen::ColMajor, kMost, 1>;

  Matrix information;  // J^T J; the lower triangle alone until Complete
  Vector gradient;     // J^T r
  double cost = 0;     // r^T r / 2

  explicit NormalEquations(int unknowns) {
    information.setZero(unknowns, unknowns);
    gradient.setZero(unknowns);
  }

  // Rows are taken four at a time: then the matrix is read and written a quarter as often.
  void Add(const Vector& row, double residual) {
    rows_[filled_] = row;
    residuals_[filled_] = residual;
    if (++filled_ == kBatch) Flush();
  }

  void Flush() {
    if (filled_ == 0) return;
    for (int i = filled_; i < kBatch; ++i) {
      rows_[i].setZero(gradient.size());
      residuals_[i] = 0;
    }
    const auto& [a, b, c, d] = rows_;
    for (Eigen::Index j = 0; j < gradient.size(); ++j) {
      const Eigen::Index n = gradient.size() - j;
      information.col(j).tail(n) += a(j) * a.tail(n) + b(j) * b.tail(n) + c(j) * c.tail(n) + d(j) * d.tail(n);
    }
    for (int i = 0; i < filled_; ++i) {
      gradient += residuals_[i] * rows_[i];
      cost += residuals_[i] * residuals_[i] / 2;
    }
    filled_ = 0;
  }

  // The last rows; the upper triangle; and rotations by w instead of by a turn of R from the left.
  void Complete(const Eigen::Matrix3d& left_jacobian) {
    Flush();
    information.template triangularView<Eigen::StrictlyUpper>() = information.transpose();
    information.template topRows<3>() =
        (left_jacobian.transpose() * information.template topRows<3>()).eval();
    information.template leftCols<3>() = (information.template leftCols<3>() * left_jacobian).eval();
    gradient.template head<3>() = (left_jacobian.transpose() * gradient.template head<3>()).eval();
  }

 private:
  static constexpr int kBatch = 4;
  Vector rows_[kBatch];
  double residuals_[kBatch] = {};
  int filled_ = 0;
};

// Of all terms of the problem at x, 6+B unknowns as ResectionProblem has them.
template <int kModes>
NormalEquations<kModes> Linearise(const ResectionProblem& problem, const double* x);

extern template NormalEquations<7> Linearise<7>(const ResectionProblem&, const double*);
extern template NormalEquations<Eigen::Dynamic> Linearise<Eigen::Dynamic>(const ResectionProblem&,
                                                                          const double*);

}  // namespace armature
