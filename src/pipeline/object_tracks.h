// SPDX-License-Identifier: BSD-3-Clause
// What the frames so far say about the objects in view: a prior for the next frame's association and resection.
//
// Positions and scale. In frame i the odometry gives the camera's rotation R_i and its position c_i, of unknown scale s;
// resection gives the object's position t_i in the camera, metric, with its covariance. A static object at p satisfies
//   R_i t_i = p - s c_i,
// linear in p and s: each track keeps the 4x4 normal equations of its p and s, all tracks share s, and old frames fade.
// Bearings are good and depths are not, so the covariances matter: they let the baseline triangulate.
// Turning in place leaves s open and p as it is.
//
// Turns. Each viewpoint prior is a vote for a direction of the object's front; priors that are turned by 180 degrees in
// one frame are outvoted by the others.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "association/object_view.h"
#include "pipeline/object_estimator.h"

namespace armature {

struct TrackOptions {
  bool enabled = true;
  double fading = 0.98;            // weight of what was known before, with each new observation
  double measurement_scale = 2;    // multiplies the standard deviations of resection
  double depth_sigma = 0.08;       // share of the distance, added along the ray: one view's error of size
  double lateral_sigma = 0.025;    // share of the distance, added across the ray: bearing, drift, the centre's definition
  double min_sigma = 0.04;         // metres: a remembered position is never surer
  double min_relative_sigma = 0.03;  // share of the distance: nor surer than this
  double vote_weight = 0.6;        // of one viewpoint prior; below 1 as errors of neighbouring frames are alike
  int min_edges = 3;               // matched edges of an estimate that is learnt from
  int min_observations = 2;        // before a track is used
  double max_gap = 5;              // seconds unseen, then it is dropped
  double scale_sigma = 3.0;        // of the logarithm-like prior on the scale, about 1; hardly a constraint
};

class ObjectTracks {
 public:
  explicit ObjectTracks(const TrackOptions& options) : options_(options) {}

  // Which track each detection continues, -1: none. Greedy one-to-one by the overlap of the boxes expected and seen.
  std::vector<int> Associate(double timestamp, const std::vector<ObjectView>& views,
                             const Eigen::Isometry3d& T_odom_camera) const;

  std::optional<ObjectMemory> Recall(int track, const Eigen::Isometry3d& T_odom_camera) const;

  // Adds an accepted estimate to its track, or starts one (track -1).
  void Learn(int track, double timestamp, const ObjectView& view, const ObjectEstimation& estimation,
             const Eigen::Isometry3d& T_odom_camera);

  // Metres per unit of odometry as the objects tell, once its standard deviation is below a tenth of it.
  std::optional<double> Scale() const;

  // Solves for positions and scale, forgets what was not seen for long.
  void Update(double timestamp);

 private:
  struct Track {
    const CategoryModel* model = nullptr;
    int observations = 0;
    double last_seen = 0;                                       // seconds
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();           // of (p, s)
    Eigen::Vector4d right_side = Eigen::Vector4d::Zero();
    Eigen::Vector3d position = Eigen::Vector3d::Zero();         // p: metres, axes of the odometry
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();   // of p given s
    Eigen::Matrix3d R_odom_object = Eigen::Matrix3d::Identity();  // last
    Eigen::VectorXd shape;                                      // running mean of the coefficients
    YawBelief yaw;
  };
  Eigen::Vector3d ExpectedTranslation(const Track& track, const Eigen::Isometry3d& T_odom_camera) const;
  Box ExpectedBox(const Track& track, const Camera& camera, const Eigen::Isometry3d& T_odom_camera) const;
  void Vote(Track& track, const ObjectView& view, const ObjectEstimation& estimation,
            const Eigen::Isometry3d& T_odom_camera) const;

  TrackOptions options_;
  std::vector<Track> tracks_;
  double scale_ = 0;        // metres per unit of odometry
  double scale_sigma_ = 1e9;
};

}  // namespace armature
