// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/scene/camera_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/random.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

struct Waypoint {
  Vector2d position{0, 0};  // world, metres
  double heading = 0;       // of the optical axis, radians
  double rise = 0;          // above the path's height, metres
  double dip = 0;           // below the path's pitch, degrees
  double roll = 0;          // degrees
};

double SmoothStep(double t) { return t * t * (3 - 2 * t); }

// After `rounds` of a counter-clockwise loop around the origin; heading: of the flight. The second half of a
// round is the first one turned by 180 degrees.
Waypoint OnLoop(double length, double width, double rounds) {
  const double radius = 0.5 * width, straight = length - width, half = straight + pi * radius;
  const double along = 2 * half * rounds;
  const double turns = std::floor(along / half);
  const double rest = along - turns * half;
  Waypoint at;
  if (rest < straight) {
    at.position = {rest - 0.5 * straight, -radius};
  } else {
    const double share = (rest - straight) / (pi * radius), angle = pi * (share - 0.5);
    at.position = Vector2d(0.5 * straight, 0) + radius * Vector2d(std::cos(angle), std::sin(angle));
    at.heading = pi * SmoothStep(share);
  }
  at.position *= std::fmod(turns, 2) == 0 ? 1 : -1;
  at.heading += pi * turns;
  return at;
}

Waypoint LoopPoint(const CameraPath& path, double share) {
  Waypoint at = OnLoop(path.length, path.width, (1 + path.overlap) * share);
  if (path.clockwise) {
    at.position.y() = -at.position.y();
    at.heading = -at.heading;
  }
  at.position += path.centre;
  at.heading += path.heading_offset_deg * kDegree;
  return at;
}

Waypoint TurnPoint(const CameraPath& path, double share) {
  const double turned = (path.clockwise ? -2 : 2) * pi * (1 + path.overlap) * share;
  return {path.centre, path.start_deg * kDegree + turned};
}

// x, y, height, heading, pitch, roll of a keyframe: metres and radians, pitch and roll in degrees; height and
// pitch against the path's.
using KeyframeValues = Eigen::Matrix<double, 6, 1>;

KeyframeValues CatmullRom(const std::array<KeyframeValues, 4>& p, double t) {
  return 0.5 * (2 * p[1] + t * (p[2] - p[0]) + t * t * (2 * p[0] - 5 * p[1] + 4 * p[2] - p[3]) +
                t * t * t * (3 * p[1] - p[0] - 3 * p[2] + p[3]));
}

// Headings go the shorter way round from one to the next.
std::vector<KeyframeValues> ListValues(const CameraPath& path) {
  std::vector<KeyframeValues> values;
  for (const CameraPath::Keyframe& key : path.keyframes) {
    double heading = key.heading_deg * kDegree;
    if (!values.empty()) heading = values.back()[3] + WrapAngle(heading - values.back()[3]);
    values.emplace_back(key.position.x(), key.position.y(), key.height.value_or(path.height) - path.height,
                        heading, key.pitch_deg.value_or(path.pitch_deg) - path.pitch_deg, key.roll_deg);
  }
  return values;
}

// Lets the curve begin or end its way from p[1] to p[2] at rest where the camera rests before or after it:
// in the rows from `first` on, `count` of them.
void RestAtPauses(bool has_before, bool has_after, int first, int count, std::array<KeyframeValues, 4>* p) {
  const auto rows = [&](size_t i) { return (*p)[i].segment(first, count); };
  const bool rests = rows(1) == rows(2);
  if (rests || (has_before && rows(0) == rows(1))) (*p)[0].segment(first, count) = rows(2).eval();
  if (rests || (has_after && rows(2) == rows(3))) (*p)[3].segment(first, count) = rows(1).eval();
}

Waypoint KeyframePoint(const CameraPath& path, double share) {
  const std::vector<KeyframeValues> values = ListValues(path);
  const int last = static_cast<int>(values.size()) - 1;
  const double along = share * last;
  const int first = std::clamp(static_cast<int>(along), 0, std::max(last - 1, 0));
  std::array<KeyframeValues, 4> around;
  for (int i = 0; i < 4; ++i) {
    around[static_cast<size_t>(i)] = values[static_cast<size_t>(std::clamp(first - 1 + i, 0, last))];
  }
  RestAtPauses(first > 0, first + 2 <= last, 0, 3, &around);
  if (around[1] == around[2])
    return {around[1].head<2>(), around[1][3], around[1][2], around[1][4], around[1][5]};
  const KeyframeValues at = CatmullRom(around, along - first);
  return {at.head<2>(), at[3], at[2], at[4], at[5]};
}

Waypoint PathPoint(const CameraPath& path, double share) {
  switch (path.kind) {
    case CameraPath::Kind::kLoop:
      return LoopPoint(path, share);
    case CameraPath::Kind::kTurn:
      return TurnPoint(path, share);
    case CameraPath::Kind::kKeyframes:
      return KeyframePoint(path, share);
  }
  std::abort();
}

// A slow, smooth function of the frame with mean 0 and standard deviation 1.
class Sway {
 public:
  explicit Sway(Random& random) {
    for (double& phase : phases_) phase = random.Uniform(0, 2 * pi);
  }
  double At(int frame) const {
    constexpr std::array<double, 3> kPeriods{23, 37, 61};  // frames
    double sum = 0;
    for (size_t i = 0; i < kPeriods.size(); ++i) sum += std::sin(2 * pi * frame / kPeriods[i] + phases_[i]);
    return std::sqrt(2.0 / 3.0) * sum;
  }

 private:
  std::array<double, 3> phases_{};
};

// The camera's axes when it looks along the heading, `pitch` below the horizon, and its image is level.
Eigen::Matrix3d LevelAxes(double heading, double pitch) {
  Eigen::Matrix3d R_world_camera;
  const Vector3d forward(std::cos(pitch) * std::cos(heading), std::cos(pitch) * std::sin(heading),
                         -std::sin(pitch));
  const Vector3d right(std::sin(heading), -std::cos(heading), 0);
  R_world_camera << right, forward.cross(right), forward;
  return R_world_camera;
}

}  // namespace

std::vector<Eigen::Isometry3d> CameraPoses(const CameraPath& path, int frames, std::uint64_t seed) {
  Random random(seed);
  const Sway x(random), y(random), z(random), roll(random), pitch(random);
  const double shift = path.kind == CameraPath::Kind::kTurn ? 0 : path.sway;
  std::vector<Eigen::Isometry3d> poses(static_cast<size_t>(frames), Eigen::Isometry3d::Identity());
  for (int i = 0; i < frames; ++i) {
    const Waypoint at = PathPoint(path, frames > 1 ? static_cast<double>(i) / (frames - 1) : 0);
    Eigen::Isometry3d& T_world_camera = poses[static_cast<size_t>(i)];
    T_world_camera.translation() = Vector3d(at.position.x(), at.position.y(), path.height + at.rise) +
                                   shift * Vector3d(x.At(i), y.At(i), z.At(i));
    const double down = (path.pitch_deg + at.dip + path.sway_deg * pitch.At(i)) * kDegree;
    T_world_camera.linear() =
        LevelAxes(at.heading, down) *
        Eigen::AngleAxisd((at.roll + path.sway_deg * roll.At(i)) * kDegree, Vector3d::UnitZ())
            .toRotationMatrix();
  }
  return poses;
}

}  // namespace armature
