// SPDX-License-Identifier: BSD-3-Clause
// Where somebody can walk in a drawn room, and where a camera can be.
#pragma once

#include <vector>

#include "datasets/rooms/drawn_room.h"
#include "geometry/random.h"

namespace armature {

class FreeFloor {
 public:
  explicit FreeFloor(const DrawnRoom& room) : room_(room) {}

  // Whether walls and everything that stands there, however low, are 0.25 m away; all the way between two
  // places.
  bool IsFree(const Eigen::Vector2d& position) const;
  bool IsFree(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

  // Whether nothing is nearer than 0.2 m to a camera there; it may be above a table.
  bool IsClear(const Eigen::Vector3d& camera) const;

  // Free where one of a hundred places is.
  Eigen::Vector2d Anywhere(Random& random) const;

 private:
  const DrawnRoom& room_;
};

// The rectangle with round corners at a distance around an object and what was placed together with it.
class Outline {
 public:
  Outline(const DrawnRoom& room, size_t object, double distance);

  double length() const;
  // World; `along` may be any number: it goes round and round.
  Eigen::Vector2d At(double along) const;
  // Of the rectangle that it goes around.
  Eigen::Vector2d NearestInside(const Eigen::Vector2d& position) const;

 private:
  Eigen::Isometry2d T_world_middle_ = Eigen::Isometry2d::Identity();
  Eigen::Vector2d half_{0, 0};  // of the rectangle
  double distance_ = 0;
};

}  // namespace armature
