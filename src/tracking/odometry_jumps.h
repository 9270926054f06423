// SPDX-License-Identifier: BSD-3-Clause
// What an odometry tells that the camera did not do: a SLAM system that was lost and found itself again, or
// closed a loop, puts the camera elsewhere from one frame to the next; one that starts anew goes on in
// another unit.
//
// A step much longer, or a turn much wider, than those before it is suspected of being a jump, a lasting
// change of speed of being one of the unit. Whether it is, the objects tell: where they are seen, and where
// they would be seen if it were. It is then taken out: the frames after it follow those before it.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <deque>
#include <functional>
#include <optional>

#include "odometry/unit_change.h"

namespace armature {

// How well the objects known so far are seen where a camera at this pose would see them; none: nothing tells.
using ObjectAgreement = std::function<std::optional<double>(const Eigen::Isometry3d& T_odom_camera)>;

class OdometryJumps {
 public:
  struct Step {
    Eigen::Isometry3d T_odom_camera = Eigen::Isometry3d::Identity();  // jumps taken out, unit of the start
    bool is_jump = false;
    std::optional<UnitChange> unit_change;  // holds for earlier frames, too
  };
  // `is_unit_known`: before it is, a change of it cannot be told.
  Step Follow(double timestamp, const Eigen::Isometry3d& T_told_camera, bool is_unit_known,
              const ObjectAgreement& agreement);

 private:
  struct Motion {
    double timestamp = 0;             // seconds
    Eigen::Isometry3d T_odom_camera;  // jumps taken out
    double seconds = 0;               // since the frame before; 0: the first
    double speed = 0, turn_rate = 0;  // units and radians a second
  };
  bool IsJump(const Motion& motion, const Eigen::Isometry3d& as_before,
              const ObjectAgreement& agreement) const;
  Eigen::Isometry3d GoOnAsBefore(double seconds) const;
  std::optional<UnitChange> SuspectUnitChange() const;
  std::optional<UnitChange> FindUnitChange(const ObjectAgreement& agreement);

  // odom = rotation * unit * told + shift
  Eigen::Matrix3d rotation_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift_ = Eigen::Vector3d::Zero();
  double unit_ = 1;
  std::deque<Motion> motions_;  // the latest

  // Around a suspected one: the camera may have changed its speed as well.
  static constexpr std::array kFactorTrials{0.8, 0.9, 1.0, 1.1, 1.25};

  // What objects have said of it since; one frame is no evidence.
  struct Suspicion {
    UnitChange change;
    int frames = 0;   // in which objects told
    double told = 0;  // sum of their agreement with the odometry as it is told
    std::array<double, kFactorTrials.size()> undone{};  // the same with the change undone, by trials
  };
  std::optional<Suspicion> suspicion_;
};

}  // namespace armature
