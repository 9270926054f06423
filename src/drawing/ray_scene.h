// SPDX-License-Identifier: BSD-3-Clause
// Rays against a room full of things, by Embree.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <span>
#include <vector>

#include "drawing/mesh.h"

namespace armature {

constexpr int kRoom = 0;  // the object number of everything that is not an object

struct PlacedMesh {
  Mesh mesh;
  Eigen::Isometry3d T_world_mesh = Eigen::Isometry3d::Identity();
  int object = kRoom;  // 1, 2, ...: the objects of the scene
};

// Which surface a ray meets.
struct RayHit {
  int mesh = -1, part = -1, quad = -1;  // indices; -1: it meets nothing
  int object = kRoom;
  double distance = 0;  // metres
  double u = 0, v = 0;  // where in the quad: corner 0 at (0, 0), 1 at (1, 0), 2 at (1, 1), 3 at (0, 1)
};

class RayScene {
 public:
  // Coordinates of rays are world, metres; directions are unit vectors.
  explicit RayScene(std::vector<PlacedMesh> meshes);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  const std::vector<PlacedMesh>& meshes() const;

  // The nearest surface, seen from either side. Thread-safe, as everything const here.
  RayHit Nearest(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;
  // The same for each of many directions, which is faster; most so if they are close to each other.
  void Nearest(const Eigen::Vector3d& origin, std::span<const Eigen::Vector3d> directions,
               std::span<RayHit> hits) const;
  // As if there were nothing but this object.
  RayHit HitNearestOfObject(int object, const Eigen::Vector3d& origin,
                            const Eigen::Vector3d& direction) const;
  // Whether something is between the points, more than 1 mm from both.
  bool IsBlocked(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  // The same for each of many points b.
  void AreBlocked(const Eigen::Vector3d& a, std::span<const Eigen::Vector3d> b,
                  std::span<char> blocked) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace armature
