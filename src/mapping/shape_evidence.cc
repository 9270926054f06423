// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/shape_evidence.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "geometry/rotation.h"
#include "mapping/object_factors.h"
#include "resection/resection_problem.h"

namespace armature {
namespace {

// Unknowns of one object: its pose's local step (rotation, translation), its shape, the logarithm of the
// scale.
Eigen::MatrixXd JointInformation(const MapGraph& graph, int object, const MapSolverOptions& options) {
  const GraphObject& of = graph.objects[static_cast<size_t>(object)];
  const Eigen::Index modes = of.coefficients.size(), size = 6 + modes + 1;
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, size);
  for (const ObjectFactor& factor : graph.observations) {
    if (factor.object != object) continue;
    const Eigen::Isometry3d T_camera_object = SeenAtUnitSize(
        graph.T_world_camera[static_cast<size_t>(factor.camera)].inverse() * of.T_world_object, of.log_size);
    Eigen::MatrixXd J(factor.A.rows(), size);
    J.leftCols(6 + modes) = factor.A;
    // A larger world has the object farther away: t_camera_object exp(s), as a step on the right R^T t ds.
    J.rightCols<1>() =
        factor.A.middleCols<3>(3) * (T_camera_object.linear().transpose() * T_camera_object.translation());
    // Cauchy: rho(r^2) = c^2 log(1 + r^2 / c^2), its derivative is the weight.
    const double squared = Residual(factor, {T_camera_object, of.coefficients}).squaredNorm();
    const double c2 = options.loss_scale * options.loss_scale * static_cast<double>(factor.b.size());
    H += J.transpose() * J / (1 + squared / c2);
  }
  return H;
}

void AddUpright(const GraphObject& object, const MapSolverOptions& options, Eigen::MatrixXd& H) {
  if (options.upright_sigma_deg <= 0) return;
  const double sigma = options.upright_sigma_deg * kDegree;
  const Eigen::Matrix3d J = object.T_world_object.linear() * Skew(Eigen::Vector3d::UnitY()) / sigma;
  H.topLeftCorner<3, 3>() += J.transpose() * J;
}

bool StandsOnFloor(const GraphObject& object) { return object.model->spec.stands_on_floor; }

// The floor is where the others stand, each as surely as this one does: without others it is anywhere.
void AddFloor(const MapGraph& graph, const GraphObject& object, const MapSolverOptions& options,
              Eigen::MatrixXd& H) {
  const auto others = std::count_if(graph.objects.begin(), graph.objects.end(), StandsOnFloor) - 1;
  if (options.floor_sigma <= 0 || !StandsOnFloor(object) || others < 1) return;
  const double sigma = options.floor_sigma * std::sqrt(1 + 1 / static_cast<double>(others));
  const ShapePoint lowest = LowestPoint(*object.model, object.coefficients);
  const Eigen::RowVector3d up_object = graph.up_world.transpose() * object.T_world_object.linear();
  Eigen::RowVectorXd J = Eigen::RowVectorXd::Zero(H.cols());
  J.head<3>() = -up_object * Skew(lowest.X0 + lowest.G * object.coefficients) / sigma;
  J.segment<3>(3) = up_object / sigma;
  J.segment(6, lowest.G.cols()) = up_object * lowest.G / sigma;
  H += J.transpose() * J;
}

// Marginal over all but the shape. A direction of the pose that nothing is known of is held by next to
// nothing, each in its own unit.
Eigen::MatrixXd OfShapeAlone(const Eigen::MatrixXd& H, Eigen::Index modes) {
  Eigen::MatrixXd nuisance(7, 7), cross(7, modes);
  nuisance << H.topLeftCorner<6, 6>(), H.topRightCorner<6, 1>(), H.bottomLeftCorner<1, 6>(),
      H.bottomRightCorner<1, 1>();
  cross << H.block(0, 6, 6, modes), H.block(6 + modes, 6, 1, modes);
  nuisance.diagonal() += 1e-9 * (nuisance.diagonal() + Eigen::VectorXd::Ones(7));
  const Eigen::MatrixXd information =
      H.block(6, 6, modes, modes) - cross.transpose() * nuisance.llt().solve(cross);
  return 0.5 * (information + information.transpose());
}

}  // namespace

ShapeEvidence ComputeShapeEvidence(const MapGraph& graph, int object, double scale_sigma,
                                   const MapSolverOptions& options) {
  const GraphObject& of = graph.objects[static_cast<size_t>(object)];
  const Eigen::Index modes = of.coefficients.size();
  Eigen::MatrixXd H = JointInformation(graph, object, options);
  AddUpright(of, options, H);
  AddFloor(graph, of, options, H);
  H.bottomRightCorner<1, 1>().array() += 1 / (scale_sigma * scale_sigma);
  ShapeEvidence evidence;
  evidence.information = OfShapeAlone(H, modes);
  const double prior = options.shape_weight * options.shape_weight;
  evidence.vector = evidence.information * of.coefficients + prior * of.coefficients;
  return evidence;
}

}  // namespace armature
