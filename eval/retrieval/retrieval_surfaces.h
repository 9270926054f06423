// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of a library's instances, to be compared with true ones.
#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "geometry/surface_distance.h"
#include "retrieval/instance_library.h"

namespace armature {

constexpr int kSurfacePoints = 8000;        // on each surface
constexpr double kSurfaceThreshold = 0.02;  // metres, of the F-score

// Whether the instance has a surface, and its file is there.
bool HasSurface(const InstanceLibrary& library, const CategoryInstances& instances, int instance);

// Points on the instance's surface in its centred object frame, metres, stretched by `scale` along the axes.
// None where it has none. Throws InputError: a malformed file.
std::optional<SurfacePoints> FindSurface(const InstanceLibrary& library, const CategoryInstances& instances,
                                         int instance, const Eigen::Vector3d& scale, int points);

// The surfaces of a library as they are; each is read when it is first asked for, and kept.
class LibrarySurfaces {
 public:
  // Keeps a reference. `points` on each surface.
  LibrarySurfaces(const InstanceLibrary& library, int points) : library_(library), points_(points) {}

  // Null where FindSurface has none.
  const SurfacePoints* Of(const CategoryInstances& instances, int instance);

 private:
  const InstanceLibrary& library_;
  int points_;
  std::map<std::pair<std::string, int>, std::optional<SurfacePoints>> surfaces_;
};

// How far the instances of one category are from one true surface; each is compared once.
class DistancesFromTruth {
 public:
  // Keeps references. `truth`: in its centred object frame, metres; none: not known.
  DistancesFromTruth(std::optional<SurfacePoints> truth, const CategoryInstances& instances,
                     LibrarySurfaces& surfaces)
      : truth_(std::move(truth)), instances_(instances), surfaces_(surfaces) {}

  // None where one of the two surfaces is not there.
  std::optional<SurfaceDistance> To(int instance);

 private:
  std::optional<SurfacePoints> truth_;
  const CategoryInstances& instances_;
  LibrarySurfaces& surfaces_;
  std::map<int, std::optional<SurfaceDistance>> distances_;
};

}  // namespace armature
