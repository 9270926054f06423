// SPDX-License-Identifier: BSD-3-Clause
// How many units of odometry a metre is, learnt while the camera goes.
//
// Before any object tells, the camera's speed does, roughly: cameras are carried through rooms by people and
// robots. So the odometry's unit may be anything, and the result is the same.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "odometry/scale_estimate.h"

namespace armature {

class OdometryUnit {
 public:
  // `is_metric`: it is the metre, and stays.
  explicit OdometryUnit(bool is_metric) : is_metric_(is_metric) {}

  // Where the camera is now; the more it has gone by then, the more its speed tells.
  void Follow(double timestamp, const Eigen::Isometry3d& T_odom_camera);

  // A better guess than the speed, of the logarithm of units a metre; it takes the speed's place.
  void Guess(double log_units);

  // What an object tells: its logarithm of distance is off by `error` (0 if the unit is right), with the
  // derivative `slope` by the unit's logarithm, 0..1, and a variance.
  void Learn(double error, double slope, double variance);

  // After what was learnt of all objects of a frame: takes effect.
  void Update();

  double units_a_metre() const { return units_; }
  double log_units() const { return log_units_; }
  ScaleEstimate Scale() const;

 private:
  void MoveGuess(double log_units);

  bool is_metric_ = false;
  double units_ = 1;      // as of the last frame
  double log_units_ = 0;  // logarithm of units a metre
  double information_ = 0;
  double guess_information_ = 0;  // its part that the guess gave, which moves with it
  double guess_ = 0;
  bool is_by_speed_ = true;
  double travelled_ = 0, seconds_ = 0;  // units and seconds from the start to the waypoint
  struct Waypoint {
    double timestamp = 0;
    Eigen::Vector3d position;
  };
  std::optional<Waypoint> waypoint_;
};

}  // namespace armature
