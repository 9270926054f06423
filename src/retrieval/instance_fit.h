// SPDX-License-Identifier: BSD-3-Clause
// How well one CAD model explains the images in which an object was seen: its own edges, projected.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "association/hypothesis_cost.h"
#include "category/category_model.h"
#include "mapping/joint_refinement.h"
#include "mapping/map_frame.h"
#include "mapping/map_solver.h"

namespace armature {

// What the images show of one object of the map: at least one of them.
struct ObjectSightings {
  // One observation each; its view's occluders are the faces of the map's other objects.
  std::vector<MapFrame> frames;
  std::vector<Eigen::Isometry3d> T_world_camera;                     // metres, one a frame; they are held
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();  // where the map has the object, metres
  Eigen::Vector3d up_world{0, -1, 0};                                // unit
};

struct InstanceFitOptions {
  double size_sigma = 0.01;  // of the logarithm of the map's scale, in which a model of known size may err
  RefinementOptions refinement{.rounds = 4, .first_gate_pixels = 10, .last_gate_pixels = 3};
  BoxOptions box;
  ResectionOptions resection;
  MapSolverOptions solver;
  CostOptions cost{.azimuth_weight = 0};  // how it is turned says nothing of which one it is
};

struct InstanceFit {
  double cost =
      0;  // mean over the views, of the visible edges' unexplained share and of the box; CostOptions
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();  // where it fits best, metres
  double scale = 1;                                                  // of the model
};

// A CAD model as a category model with one mode: its size.
CategoryModel MakeInstanceModel(const CategorySpec& spec, const Wireframe& wireframe, double size_sigma);

// Fits the model's edges (object frame, centred, metres; `size_sigma`: of the logarithm of their size,
// besides the map's) to all frames' lines and boxes from where the map has the object, as the map's joint
// refinement does, and measures what they explain there.
InstanceFit FitInstance(const ObjectSightings& sightings, const CategorySpec& spec,
                        const Wireframe& wireframe, double size_sigma, const InstanceFitOptions& options);

}  // namespace armature
