// SPDX-License-Identifier: BSD-3-Clause
// The CAD models that a run found for its objects.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "retrieval/instance_library.h"

namespace armature {

// A row of retrieval.csv.
struct RetrievedModel {
  std::string name;                                 // the instance's id
  double distance = 0;                              // of the shape
  std::optional<double> cost;                       // of its fit; none: it was not fitted
  std::optional<Eigen::Isometry3d> T_world_object;  // where it was fitted, the run's world
  double scale = 1;                                 // of the fitted model
};

// By the object's id, nearest first; without the file nothing. Throws InputError: malformed.
std::map<std::string, std::vector<RetrievedModel>> ReadRetrieval(const std::filesystem::path& run);

// The model's surface in its centred object frame, metres. None: there is no library, or it has no surface of
// the model. Throws InputError: the library has not the model, a surface that is missing or malformed.
std::optional<TriangleMesh> LoadModelSurface(const InstanceLibrary& library, const std::string& category,
                                             const std::string& name);

}  // namespace armature
