// SPDX-License-Identifier: BSD-3-Clause
// Single-view estimates and odometry become one consistent metric map (paper 3.5).
#pragma once

#include <string>
#include <vector>

#include "mapping/joint_refinement.h"
#include "mapping/map_frame.h"
#include "mapping/map_graph.h"
#include "mapping/map_objects.h"
#include "mapping/map_solver.h"
#include "mapping/object_association.h"

namespace armature {

struct MappingOptions {
  int min_observations = 4;   // frames that agree before an object is kept
  bool loop_closure = true;   // objects seen again later are the same objects; else only those seen recently
  double recent_seconds = 3;  // what recently means
  OdometryOptions odometry;
  ObjectAssociationOptions association;
  FactorNoise view_noise;  // of single-view estimates, before the refinement
  MapSolverOptions solver;
  RefinementOptions refinement;
};

struct MapObject {
  std::string id;  // "chair0": category and number, in the order in which they were first seen
  const CategoryModel* model = nullptr;
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();  // metres
  Eigen::VectorXd coefficients;                                      // standard deviations
  int observations = 0;                                              // detections that it explains
};

struct Map {
  std::vector<double> timestamps;                          // seconds, of the cameras
  std::vector<Eigen::Isometry3d> T_world_camera;           // metres
  std::vector<Eigen::Isometry3d> T_world_camera_odometry;  // the odometry alone, times the mean scale
  std::vector<MapObject> objects;
  ObjectOfObservation phi;        // indices into `objects`
  double final_cost = 0;
  std::vector<double> log_scale;  // of metres a unit of odometry, at the knots
};

// The map of all frames, from scratch. `initial_scale`: metres a unit of odometry, as the front end has learnt
// it. At least one frame.
Map SolveMap(const std::vector<MapFrame>& frames, double initial_scale, const BoxOptions& box,
             const ResectionOptions& resection, const MappingOptions& options);

}  // namespace armature
