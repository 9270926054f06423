// SPDX-License-Identifier: BSD-3-Clause
// The factor graph of paper 3.5: cameras, objects, and what ties them together.
//
// Unknowns: the cameras T_world_camera (the paper's Z_i^-1), the objects T_world_object (Z_O) with their
// shapes and sizes, the odometry's scale, and up. The world is the odometry's frame in metres: the first
// camera stays where the odometry has it.
//
// Scale. Objects are metric, monocular odometry is not, and its unit drifts slowly as it goes. We keep
// cameras and objects on SE(3), in metres, and let the odometry's steps be multiplied by exp(s), s the
// logarithm of metres a unit: piecewise linear between knots over time, a random walk from knot to knot. A
// pose graph on Sim(3) could bend in the same way but gives every node a scale of its own, objects included,
// that a metric object would then have to pin; here scale is where its cause is, one number each few seconds,
// and its uncertainty can be read off.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "association/object_view.h"
#include "category/category_model.h"
#include "geometry/se3.h"
#include "odometry/scale_estimate.h"

namespace armature {

struct GraphObject {
  const CategoryModel* model = nullptr;
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();  // metres
  Eigen::VectorXd coefficients;                                      // standard deviations
  // Of the factor by which all of it is larger than the category's shape: what is mapped stands in a room of
  // one scale, and furniture differs in size.
  double log_size = 0;
};

// How one camera sees an object: as one of the category's own size would be seen that is so much nearer. Both
// have the same picture.
inline Eigen::Isometry3d SeenAtUnitSize(const Eigen::Isometry3d& T_camera_object, double log_size) {
  Eigen::Isometry3d seen = T_camera_object;
  seen.translation() *= std::exp(-log_size);
  return seen;
}

// The odometry's step between two cameras: e = Log(Z_ij^-1 X_i^-1 X_j), X = T_world_camera, Z_ij its relative
// pose with the translation times exp(s), s = (1 - share) s[knot] + share s[knot + 1].
struct OdometryFactor {
  int from = 0, to = 0;                                         // cameras
  Eigen::Isometry3d T_from_to = Eigen::Isometry3d::Identity();  // the odometry's unit
  double rotation_sigma = 1, translation_sigma = 1;             // radians, metres
  int knot = 0;
  double share = 0;
};

// What one image says about one object, to second order about a pose and shape: the residual is A d + b with
// d = (Log(at^-1 X_i^-1 X_O), coefficients - those of `at`), 6 + B numbers, rotation first.
struct ObjectFactor {
  int camera = 0, object = 0;
  PoseAndShape at;    // T_camera_object, the paper's Zm^i_O, and shape
  Eigen::MatrixXd A;  // (6+B) x (6+B), L^T of the information L L^T
  Eigen::VectorXd b;  // 6+B; 0: `at` is the image's own optimum
};

// The camera is so high above the floor, metres.
struct HeightFactor {
  int camera = 0;
  double height = 0, sigma = 1;
};

struct MapGraph {
  std::vector<Eigen::Isometry3d> T_world_camera;  // metres; the first is held
  std::vector<GraphObject> objects;
  std::vector<OdometryFactor> odometry;
  std::vector<ObjectFactor> observations;
  std::vector<HeightFactor> heights;
  std::vector<double> log_scale;  // logarithm of metres a unit of odometry, at the knots
  ScaleEstimate expected_scale;
  bool scale_is_held = false;          // log_scale stays as it is
  bool sizes_are_held = true;          // log_size stays as it is
  bool cameras_are_held = false;       // only objects move
  Eigen::Vector3d up_world{0, -1, 0};  // unit
  double up_sigma = 0.05;              // radians, of up_world as given
};

}  // namespace armature
