// SPDX-License-Identifier: BSD-3-Clause
// A furnished room to be drawn. World frame: z up, the floor at z = 0, metres.
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "datasets/furniture.h"
#include "datasets/solids.h"

namespace armature {

struct PlacedFurniture {
  std::string id;
  Furniture furniture;
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();
};

// Where furniture stands that is turned about the vertical: at yaw 0 its front (+z) faces -y of the world.
// `height`: of the surface it stands on, metres; `yaw_deg`: counter-clockwise seen from above.
PlacedFurniture Placed(const std::string& id, const Furniture& furniture, double x, double y, double yaw_deg,
                       double height = 0);

struct RoomShape {
  Eigen::Vector2d low{-2.7, -3.4}, high{2.7, 2.3};  // corners of the floor, metres
  double height = 2.6;                              // metres
};

// Floor boards, walls with skirting boards, a rug, pictures and a door: everything that is not an object.
std::vector<Polygon> RoomPolygons(const RoomShape& shape, std::uint64_t seed);

// The furniture's sides; polygons of the i-th piece have the object number i + 1.
std::vector<Polygon> FurniturePolygons(const std::vector<PlacedFurniture>& furniture);

// One lamp below the ceiling. Soft shadows of the furniture are on the floor only.
class RoomLight {
 public:
  RoomLight(const RoomShape& shape, const std::vector<PlacedFurniture>& furniture);

  // The factor of a surface's colour at a point, world frame.
  double operator()(const Polygon& polygon, const Eigen::Vector3d& point) const;

 private:
  double FloorVisibility(const Eigen::Vector3d& point) const;  // share of the lamp that is seen, 0..1

  Eigen::Vector3d lamp_;
  Eigen::Vector2d low_;
  cv::Mat1d visibility_;  // of floor points, a cell each, rows along y
};

}  // namespace armature
