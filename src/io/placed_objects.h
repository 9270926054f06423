// SPDX-License-Identifier: BSD-3-Clause
// The objects of a run's map, as its files tell them.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mapping/object_uncertainty.h"

namespace armature {

struct PlacedObject {
  std::string id;
  std::string category;
  std::string instance;                                              // the CAD model, empty: not retrieved
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();  // metres, the run's world
  Eigen::Vector3d size{0, 0, 0};                                     // metres, along the object's axes
  int observations = 0;                                              // it was made from
  std::vector<double> shape;                                         // coefficients, standard deviations
  std::optional<double> probability{};                               // that it is there; none: not known
  std::optional<PoseAndSizeCovariance> covariance{};                 // of its pose and size; none: not known
};

// objects.csv or objects_odometry.csv of a run folder; a table without rows is a map without objects. Throws
// InputError: missing or malformed file, an id that is empty or occurs twice, a negative size or count, a
// covariance that is none: not 45 numbers (the upper triangle of 9 x 9, row by row), or not positive
// definite.
std::vector<PlacedObject> ReadPlacedObjects(const std::filesystem::path& file);

}  // namespace armature
