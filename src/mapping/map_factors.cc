// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/map_factors.h"

#include <cmath>

#include "geometry/rotation.h"
#include "mapping/pose_block.h"
#include "mapping/relative_pose_error.h"
#include "mapping/supports.h"
#include "resection/resection_problem.h"

namespace armature {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using RowMajorMap = Eigen::Map<RowMajor>;
using Matrix3by7 = Eigen::Map<Eigen::Matrix<double, 3, 7, Eigen::RowMajor>>;

}  // namespace

// Scale: Z^-1 X_i^-1 X_j = (R_Z^T R, R_Z^T (t - exp(s) t_Z)), so its translation moves by -R_Z^T exp(s) t_Z
// ds; as a step of it on its right, and so of X_j, that is (R_Z^T R)^T times it: -R^T exp(s) t_Z ds.
bool OdometryCost::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const double scale = std::exp((1 - factor_.share) * parameters[2][0] + factor_.share * parameters[3][0]);
  Eigen::Isometry3d Z = factor_.T_from_to;
  Z.translation() *= scale;
  const RelativePoseError error(Z.inverse(), FromBlock(parameters[0]), FromBlock(parameters[1]));
  Vector6d weight;
  weight.head<3>().setConstant(1 / factor_.rotation_sigma);
  weight.tail<3>().setConstant(1 / factor_.translation_sigma);
  Eigen::Map<Vector6d>{residuals} = weight.cwiseProduct(error.e);
  if (!jacobians) return true;
  const Matrix6d by_to = weight.asDiagonal() * error.ByTo();
  if (jacobians[0]) StoreByStep(by_to * error.ToByFrom(), jacobians[0]);
  if (jacobians[1]) StoreByStep(by_to, jacobians[1]);
  const Eigen::Vector3d to_by_log_scale = -error.T_from_to.linear().transpose() * Z.translation();
  const Vector6d by_log_scale = by_to.rightCols<3>() * to_by_log_scale;
  if (jacobians[2]) Eigen::Map<Vector6d>{jacobians[2]} = (1 - factor_.share) * by_log_scale;
  if (jacobians[3]) Eigen::Map<Vector6d>{jacobians[3]} = factor_.share * by_log_scale;
  return true;
}

ObjectCost::ObjectCost(const ObjectFactor& factor) : factor_(factor) {
  const int modes = static_cast<int>(factor.at.coefficients.size());
  mutable_parameter_block_sizes()->assign({7, 7, modes, 1});
  set_num_residuals(6 + modes);
}

// Size: with k = exp(-log size), the object is seen at (R, k t), T_camera_object = (R, t). A step (w, v) of
// T_camera_object on its right is one of (w, k v) there; and k changes by -k, which is a step of -k R^T t.
bool ObjectCost::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const Eigen::Index modes = factor_.at.coefficients.size(), rows = 6 + modes;
  const RelativePoseError metric(Eigen::Isometry3d::Identity(), FromBlock(parameters[0]),
                                 FromBlock(parameters[1]));
  const double k = std::exp(-parameters[3][0]);
  const Eigen::Isometry3d seen = SeenAtUnitSize(metric.T_from_to, parameters[3][0]);
  const RelativePoseError error(factor_.at.T_camera_object.inverse(), Eigen::Isometry3d::Identity(), seen);
  Eigen::Map<Eigen::VectorXd> r(residuals, rows);
  r = factor_.b;
  r.noalias() += factor_.A.leftCols<6>() * error.e;
  r.noalias() += factor_.A.rightCols(modes) *
                 (Eigen::Map<const Eigen::VectorXd>(parameters[2], modes) - factor_.at.coefficients);
  if (!jacobians) return true;
  Eigen::Matrix<double, Eigen::Dynamic, 6> by_object = factor_.A.leftCols<6>() * error.ByTo();
  if (jacobians[3]) {
    Eigen::Map<Eigen::VectorXd>(jacobians[3], rows) =
        -by_object.rightCols<3>() * (seen.linear().transpose() * seen.translation());
  }
  by_object.rightCols<3>() *= k;
  if (jacobians[0]) StoreByStep(by_object * metric.ToByFrom(), jacobians[0]);
  if (jacobians[1]) StoreByStep(by_object, jacobians[1]);
  if (jacobians[2]) RowMajorMap(jacobians[2], rows, modes) = factor_.A.rightCols(modes);
  return true;
}

bool UprightCost::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const Eigen::Matrix3d R = FromBlock(parameters[0]).linear();
  const Eigen::Map<const Eigen::Vector3d> up(parameters[1]);
  Eigen::Map<Eigen::Vector3d>{residuals} = (R.col(1) - up) / sigma_;
  if (!jacobians) return true;
  if (jacobians[0]) {
    Matrix3by7 J(jacobians[0]);
    J.setZero();
    J.leftCols<3>() = -R * Skew(Eigen::Vector3d::UnitY()) / sigma_;  // R exp(w) e_y = R (e_y - [e_y]x w)
  }
  if (jacobians[1]) {
    Eigen::Map<Eigen::Matrix3d>{jacobians[1]} = -Eigen::Matrix3d::Identity() / sigma_;
  }
  return true;
}

FloorCost::FloorCost(const GraphObject& object, double sigma) : sigma_(sigma) {
  const ShapePoint lowest = LowestPoint(*object.model, object.coefficients);
  point_ = lowest.X0;
  by_shape_ = lowest.G;
  mutable_parameter_block_sizes()->assign({7, static_cast<int>(lowest.G.cols()), 1, 3, 1});
  set_num_residuals(1);
}

bool FloorCost::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const Eigen::Isometry3d T_world_object = FromBlock(parameters[0]);
  const Eigen::Map<const Eigen::VectorXd> coefficients(parameters[1], by_shape_.cols());
  const double size = std::exp(parameters[2][0]);
  const Eigen::Map<const Eigen::Vector3d> up(parameters[3]);
  const Eigen::Vector3d point = size * (point_ + by_shape_ * coefficients);
  const Eigen::Vector3d point_world = T_world_object * point;
  residuals[0] = (up.dot(point_world) - parameters[4][0]) / sigma_;
  if (!jacobians) return true;
  const Eigen::RowVector3d up_object = up.transpose() * T_world_object.linear();
  if (jacobians[0]) {
    Eigen::Map<Eigen::Matrix<double, 1, 7>> J(jacobians[0]);
    J << -up_object * Skew(point) / sigma_, up_object / sigma_, 0;
  }
  if (jacobians[1])
    Eigen::Map<Eigen::RowVectorXd>(jacobians[1], by_shape_.cols()) = size * up_object * by_shape_ / sigma_;
  if (jacobians[2]) jacobians[2][0] = up_object.dot(point) / sigma_;
  if (jacobians[3]) Eigen::Map<Eigen::Vector3d>{jacobians[3]} = point_world / sigma_;
  if (jacobians[4]) jacobians[4][0] = -1 / sigma_;
  return true;
}

SupportCost::SupportCost(const GraphObject& object, const GraphObject& on, int face, double sigma)
    : sigma_(sigma) {
  const std::array points{LowestPoint(*object.model, object.coefficients), FaceCentre(*on.model, face)};
  for (size_t k = 0; k < 2; ++k) {
    point_[k] = points[k].X0;
    by_shape_[k] = points[k].G;
    for (const int size : {7, static_cast<int>(points[k].G.cols()), 1})
      mutable_parameter_block_sizes()->push_back(size);
  }
  mutable_parameter_block_sizes()->push_back(3);
  set_num_residuals(1);
}

bool SupportCost::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const Eigen::Map<const Eigen::Vector3d> up(parameters[6]);
  Eigen::Vector3d apart = Eigen::Vector3d::Zero();
  for (const size_t k : {0, 1}) {
    const size_t first = 3 * k;
    const double sign = k == 0 ? 1 : -1;
    const Eigen::Isometry3d T_world_object = FromBlock(parameters[first]);
    const Eigen::Map<const Eigen::VectorXd> coefficients(parameters[first + 1], by_shape_[k].cols());
    const double size = std::exp(parameters[first + 2][0]);
    const Eigen::Vector3d point = size * (point_[k] + by_shape_[k] * coefficients);
    apart += sign * (T_world_object * point);
    if (!jacobians) continue;
    const Eigen::RowVector3d up_object = sign / sigma_ * up.transpose() * T_world_object.linear();
    if (jacobians[first]) {
      Eigen::Map<Eigen::Matrix<double, 1, 7>> J(jacobians[first]);
      J << -up_object * Skew(point), up_object, 0;
    }
    if (jacobians[first + 1]) {
      Eigen::Map<Eigen::RowVectorXd>(jacobians[first + 1], by_shape_[k].cols()) =
          size * up_object * by_shape_[k];
    }
    if (jacobians[first + 2]) jacobians[first + 2][0] = up_object.dot(point);
  }
  residuals[0] = up.dot(apart) / sigma_;
  if (jacobians && jacobians[6]) Eigen::Map<Eigen::Vector3d>{jacobians[6]} = apart / sigma_;
  return true;
}

bool HeightCost::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const Eigen::Isometry3d T_world_camera = FromBlock(parameters[0]);
  const Eigen::Map<const Eigen::Vector3d> up(parameters[1]);
  residuals[0] = (up.dot(T_world_camera.translation()) - parameters[2][0] - factor_.height) / factor_.sigma;
  if (!jacobians) return true;
  if (jacobians[0]) {
    Eigen::Map<Eigen::Matrix<double, 1, 7>> J(jacobians[0]);
    J << Eigen::RowVector3d::Zero(), up.transpose() * T_world_camera.linear() / factor_.sigma, 0;
  }
  if (jacobians[1]) Eigen::Map<Eigen::Vector3d>{jacobians[1]} = T_world_camera.translation() / factor_.sigma;
  if (jacobians[2]) jacobians[2][0] = -1 / factor_.sigma;
  return true;
}

bool RandomWalkCost::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  residuals[0] = (parameters[1][0] - parameters[0][0]) / sigma_;
  if (!jacobians) return true;
  if (jacobians[0]) jacobians[0][0] = -1 / sigma_;
  if (jacobians[1]) jacobians[1][0] = 1 / sigma_;
  return true;
}

}  // namespace armature
