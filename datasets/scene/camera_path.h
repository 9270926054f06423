// SPDX-License-Identifier: BSD-3-Clause
// Where the camera is: paths of a small flying robot at constant height, and any others through keyframes.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

namespace armature {

struct CameraPath {
  enum class Kind {
    kLoop,       // elongated: two parallel straights joined by half circles, once around and somewhat further
    kTurn,       // a full turn in place, without translation
    kKeyframes,  // smoothly through given poses
  };
  struct Keyframe {
    Eigen::Vector2d position{0, 0};     // x, y of the world, metres
    double heading_deg = 0;             // of the optical axis, counter-clockwise from the world's x
    std::optional<double> height{};     // metres; none: the path's
    std::optional<double> pitch_deg{};  // none: the path's
    double roll_deg = 0;                // about the optical axis, clockwise as the camera sees it
  };

  Kind kind = Kind::kLoop;
  Eigen::Vector2d centre{0, 0};     // of loop or turn; world, metres
  double height = 1.3;              // above the floor, metres
  double pitch_deg = 15;            // of the optical axis below the horizon
  double length = 4, width = 1.5;   // of the loop, end to end along the world's x and y; metres
  double overlap = 0.1;             // how far the path goes on after one round or turn, share of it
  double heading_offset_deg = -60;  // of the optical axis against the direction of flight; positive: left
  double start_deg = 0;             // heading of the turn's first frame
  bool clockwise = false;
  std::vector<Keyframe> keyframes;  // of kKeyframes; evenly spaced in time
  double sway_deg = 0.7;            // of roll and pitch, as hovering makes it; standard deviation
  double sway = 0.008;              // of each coordinate of the position, metres, the same; none on a turn
};

// T_world_camera (x right, y down, z forward) of `frames` images, evenly along the path from its first point
// to its last. A loop starts at its corner of least x and y (clockwise: of least x and greatest y) along the
// world's x, at constant speed; in its half circles the heading turns smoothly from one straight's to the
// other's. Keyframes are passed on a Catmull-Rom curve; where
// two in a row have one position (and height), the camera stays there between them, and where they are the
// same in all, it does not move at all. Sway is slow (periods of some twenty to sixty images)
// and drawn with the seed.
std::vector<Eigen::Isometry3d> CameraPoses(const CameraPath& path, int frames, std::uint64_t seed);

}  // namespace armature
