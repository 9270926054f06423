// SPDX-License-Identifier: BSD-3-Clause
// The residuals of the map's factor graph for Ceres, with their derivatives. Poses are blocks of
// pose_block.h.
#pragma once

#include <ceres/cost_function.h>
#include <ceres/sized_cost_function.h>

#include <Eigen/Core>
#include <array>

#include "mapping/map_graph.h"

namespace armature {

// Blocks: camera i, camera j, log scale at the knot, at the next. 6 residuals.
class OdometryCost : public ceres::SizedCostFunction<6, 7, 7, 1, 1> {
 public:
  explicit OdometryCost(const OdometryFactor& factor) : factor_(factor) {}
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  OdometryFactor factor_;
};

// Blocks: camera, object, coefficients, log size. 6 + B residuals.
class ObjectCost : public ceres::CostFunction {
 public:
  explicit ObjectCost(const ObjectFactor& factor);
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  const ObjectFactor& factor_;  // outlives the problem
};

// The object's y axis is up. Blocks: object, up (3). 3 residuals: (R e_y - up) / sigma.
class UprightCost : public ceres::SizedCostFunction<3, 7, 3> {
 public:
  explicit UprightCost(double sigma) : sigma_(sigma) {}
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  double sigma_;  // radians
};

// The object stands on the floor. Blocks: object, coefficients, log size, up (3), floor's height along up. 1
// residual: (up . X - height) / sigma, X the object's lowest point.
class FloorCost : public ceres::CostFunction {
 public:
  FloorCost(const GraphObject& object, double sigma);
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  Eigen::Vector3d point_;      // mean shape, object frame
  Eigen::Matrix3Xd by_shape_;  // 3 x B
  double sigma_;               // metres
};

// An object stands on a face of another. Blocks: the object, its coefficients, log size, the other's, up (3).
// 1 residual: how far the one's lowest point is above the other's face, over sigma.
class SupportCost : public ceres::CostFunction {
 public:
  SupportCost(const GraphObject& object, const GraphObject& on, int face, double sigma);
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  std::array<Eigen::Vector3d, 2> point_;      // mean shape, object frame: of the one, of the other
  std::array<Eigen::Matrix3Xd, 2> by_shape_;  // 3 x B
  double sigma_;                              // metres
};

// A camera's height above the floor. Blocks: camera, up (3), floor's height along up. 1 residual.
class HeightCost : public ceres::SizedCostFunction<1, 7, 3, 1> {
 public:
  explicit HeightCost(const HeightFactor& factor) : factor_(factor) {}
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  HeightFactor factor_;
};

// (x2 - x1) / sigma: a step of a random walk.
class RandomWalkCost : public ceres::SizedCostFunction<1, 1, 1> {
 public:
  explicit RandomWalkCost(double sigma) : sigma_(sigma) {}
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  double sigma_;
};

}  // namespace armature
