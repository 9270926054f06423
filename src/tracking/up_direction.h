// SPDX-License-Identifier: BSD-3-Clause
// Which way is up: made consistent over the frames by the odometry's rotations.
#pragma once

#include <Eigen/Geometry>
#include <deque>
#include <optional>
#include <vector>

#include "association/detection.h"
#include "base/enum_names.h"
#include "geometry/camera.h"
#include "geometry/segment.h"

namespace armature {

enum class UpSource {
  kAuto,      // the sequence's where given, else estimated
  kEstimate,  // from lines and viewpoints
  kLevel,     // the camera's, as if it were level
};

template <>
struct EnumNames<UpSource> {
  static constexpr NamedValue<UpSource> kTable[] = {
      {UpSource::kAuto, "auto"}, {UpSource::kEstimate, "estimate"}, {UpSource::kLevel, "level"}};
};

struct UpOptions {
  UpSource source = UpSource::kAuto;
  double viewpoint_sigma_deg = 5;  // degrees: of one detection's elevation and tilt
};

// Degrees, tuned on office_dev and redkitchen_a: standard deviation of one detection's elevation and tilt
// where the box may not show the whole object, and of the assumption of a level camera, in each frame.
inline constexpr double kOpenBoxSigmaDeg = 15, kLevelSigmaDeg = 20;

struct UpEstimate {
  Eigen::Vector3d up_camera{0, -1, 0};  // unit, camera frame
  double sigma = 1;                     // radians, standard deviation as estimated
};

// One detection's elevation and tilt say where up is, if the ray that they are measured about is known.
struct UpVote {
  Eigen::Vector3d up_camera{0, -1, 0};  // unit, camera frame
  double sigma = 1;                     // radians
};

// The vote of a detection whose object lies along the ray (camera frame), if it has elevation and tilt.
std::optional<UpVote> MakeUpVote(const Detection& detection, const Eigen::Vector3d& ray, double sigma_deg);

// Three kinds of evidence, each seldom wrong where another is: the detections' elevations and tilts say where
// up is to a few degrees each, the vertical segments say it precisely once it is roughly known (their planes
// through the camera hold it: the vanishing point of the verticals), and a camera is rarely held far from
// level. Memory is bounded by the window.
class UpEstimator {
 public:
  // Up in a new frame, before its objects are looked at. `T_odom_camera` missing: what the earlier frames
  // said cannot be used and is forgotten.
  UpEstimate Predict(const Camera& camera, const std::vector<Segment>& segments,
                     const std::vector<UpVote>& votes, const std::optional<Eigen::Isometry3d>& T_odom_camera);

  // Replaces the last frame's votes: once an object's pose is known, so is the ray to its centre, which the
  // centre of a box that shows only part of the object is not (off by 10 degrees in elevation where furniture
  // hides furniture).
  void Update(const std::vector<UpVote>& votes);

 private:
  struct FrameEvidence {                         // all in the frame of the odometry, unit
    std::vector<Eigen::Vector3d> plane_normals;  // of segments' planes through the camera
    std::vector<double> weights;                 // of those, 0..1, by length
    std::vector<UpVote> votes;                   // level camera first
    Eigen::Matrix3d R_odom_camera;
  };
  FrameEvidence Observe(const Camera& camera, const std::vector<Segment>& segments,
                        const Eigen::Matrix3d& R_odom_camera) const;
  struct Refined {
    Eigen::Vector3d up;           // unit, frame of the odometry
    Eigen::Matrix3d information;  // cost of a direction u: u^T information u
    double support = 0;           // segments that agree, weighted
  };
  Eigen::Vector3d RoughUp() const;
  Refined Refine(const Eigen::Vector3d& start, double cone, const Eigen::Vector3d& rough,
                 double rough_sigma) const;
  Refined RefineNearViewpoints(const Eigen::Vector3d& rough) const;
  Refined RefineFromPitches(const Eigen::Vector3d& rough, double rough_sigma) const;

  std::deque<FrameEvidence> window_;
  std::optional<Eigen::Vector3d> last_up_odom_;  // unit
};

}  // namespace armature
