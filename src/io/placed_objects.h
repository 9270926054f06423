// SPDX-License-Identifier: BSD-3-Clause
// The objects of a run's map, as its files tell them.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

namespace armature {

struct PlacedObject {
  std::string id;
  std::string category;
  std::string instance;                                              // the CAD model, empty: not retrieved
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();  // metres, the run's world
  Eigen::Vector3d size{0, 0, 0};                                     // metres, along the object's axes
  int observations = 0;                                              // it was made from
  std::vector<double> shape;                                         // coefficients, standard deviations
};

// objects.csv or objects_odometry.csv of a run folder; a table without rows is a map without objects. Throws
// InputError: missing or malformed file, an id that is empty or occurs twice, a negative size or count.
std::vector<PlacedObject> ReadPlacedObjects(const std::filesystem::path& file);

}  // namespace armature
