// SPDX-License-Identifier: BSD-3-Clause
// Single-view estimates and odometry become one consistent metric map (paper 3.5): which observations are of
// one object, the factor graph, and the joint refinement over all frames' lines.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mapping/joint_refinement.h"
#include "mapping/map_frame.h"
#include "mapping/map_graph.h"
#include "mapping/map_objects.h"
#include "mapping/map_solver.h"
#include "mapping/object_association.h"
#include "mapping/object_uncertainty.h"
#include "mapping/shape_evidence.h"

namespace armature {

struct MappingOptions {
  int min_observations = 4;   // frames that agree before an object is kept
  bool loop_closure = true;   // objects seen again later are the same objects; else only those seen recently
  double recent_seconds = 3;  // what recently means
  StepNoise odometry;
  ObjectAssociationOptions association;
  MapSolverOptions solver;
  RefinementOptions refinement;
};

// Without loop closure, only objects seen within these seconds are candidates.
std::optional<double> SecondsBetween(const MappingOptions& options);

struct MapObject {
  std::string id;  // "chair0": category and number, in the order in which they were first seen
  const CategoryModel* model = nullptr;
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();  // metres
  Eigen::VectorXd coefficients;                                      // standard deviations
  double log_size = 0;     // of the factor by which it is larger than that shape
  int observations = 0;    // detections that the map explains with it
  ShapeEvidence evidence;  // of the shape, without the category's prior; of placed by odometry: the map's
  std::optional<ObjectUncertainty> uncertainty{};  // of maps from all detections; none: not known

  // Its edges, object frame, metres.
  Wireframe MakeWireframe() const;
  // Along the object's axes, padding included, metres.
  Eigen::Vector3d Size() const;
};

struct Map {
  std::vector<std::shared_ptr<const CategoryModel>> models;  // that `objects` point into, kept alive
  std::vector<double> timestamps;                            // seconds, one a camera
  std::vector<Eigen::Isometry3d> T_world_camera;             // metres; the world is the odometry's frame
  std::vector<MapObject> objects;
  ObjectOfObservation phi;        // indices into `objects`
  std::vector<double> log_scale;  // of metres a unit of odometry, at the knots
  // Standard deviation of the mean of log_scale, the objects' unknown sizes included; where it was asked for.
  std::optional<double> scale_sigma;

  double MeanScale() const;  // metres a unit of odometry
};

// The map of all frames, from scratch. At least one frame. `expected_scale`: as the front end has learnt it;
// sigma 0: known, and held.
Map SolveMap(const std::vector<MapFrame>& frames, const ScaleEstimate& expected_scale, const BoxOptions& box,
             const ResectionOptions& resection, const MappingOptions& options);

// The same objects and phi with cameras where the odometry alone, times the map's mean scale, has them: each
// object where its single views put it, no object moves a camera. What the paper compares with ("ORB").
Map PlaceByOdometry(const std::vector<MapFrame>& frames, const Map& map, const MappingOptions& options);

}  // namespace armature
