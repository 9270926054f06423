// SPDX-License-Identifier: BSD-3-Clause
// What the frames so far say about the objects in view: a prior for the next frame's association and
// resection.
//
// Each track is a linear filter over z = (q, yaw, lambda): the object's centre q in the odometry's frame and
// unit, its turn about up, and its shape. In frame i the odometry gives the camera's rotation R_i and its
// position c_i; resection measures t_i, the object's position in the camera in metres, its yaw and its shape,
// with their joint covariance. With u units of odometry a metre, the same for all objects, and objects that
// do not move,
//   q - u R_i t_i = c_i,   yaw = yaw_i,   lambda = lambda_i,
// linear in z and u: each track keeps the normal equations of its z and u, and old frames fade. Weights are
// in metres, so that nothing depends on the odometry's unit and none is left from when u was not yet known.
// Bearings are good and depths are not, one end of a table says nothing of the other: so the covariances
// matter, they let the baseline triangulate and the views complete each other. Turning in place leaves u open
// and q / u as it is. (With metric centres and an unknown scale of c_i the equations are linear too, but
// noisy bearings then shrink the map: the residuals across the rays vanish with the scale. We measured 18 %
// after 20 frames.)
//
// Fronts. Each viewpoint prior is a vote for a direction of the object's front; priors that are turned by 180
// degrees in one frame are outvoted by the others.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "association/object_view.h"
#include "odometry/scale_estimate.h"
#include "resection/single_view_result.h"
#include "tracking/odometry_unit.h"

namespace armature {

struct TrackOptions {
  bool enabled = true;
  double max_gap = 20;  // seconds unseen, then a track is dropped
};

// Matched edges of an estimate that is learnt from; fewer leave pose and shape loose.
inline constexpr int kLeastLearntEdges = 3;

constexpr int kNoTrack = -1;

class ObjectTracks {
 public:
  explicit ObjectTracks(const TrackOptions& options, bool odometry_is_metric = false)
      : options_(options), unit_(odometry_is_metric) {}

  // Before everything else of a frame: where the odometry has the camera.
  void Follow(double timestamp, const Eigen::Isometry3d& T_odom_camera);

  // The id of the track that each view continues, kNoTrack: none. Greedy one-to-one by the overlap of the
  // boxes expected and seen.
  std::vector<int> Associate(double timestamp, const std::vector<ObjectView>& views,
                             const Eigen::Isometry3d& T_odom_camera) const;

  // How well the detections lie where this camera would see the objects of tracks: the sum of the agreements
  // of those that Associate pairs. None where no track is in view.
  std::optional<double> Agreement(double timestamp, const std::vector<ObjectView>& views,
                                  const Eigen::Isometry3d& T_odom_camera) const;

  // What the track says of its object in this camera; none of kNoTrack, of a young track, behind the camera.
  std::optional<TrackPrior> Predict(int id, const Eigen::Isometry3d& T_odom_camera,
                                    const Eigen::Vector3d& up_camera) const;

  // Adds an accepted estimate to the track, or starts one (kNoTrack). Returns its id, which no other track
  // has or had.
  int Update(int id, double timestamp, const ObjectView& view, const SingleViewResult& result,
             const Eigen::Isometry3d& T_odom_camera);

  // After all updates of a frame: positions, turns, shapes and scale; forgets what was not seen for long.
  void Solve(double timestamp);

  // Metres per unit of odometry as the objects tell.
  ScaleEstimate Scale() const { return unit_.Scale(); }

 private:
  // Unknowns of a track's normal equations: q / u (3), yaw, lambda (B), 1: metres.
  struct Track {
    int id = 0;
    const CategoryModel* model = nullptr;
    int observations = 0;
    double last_seen = 0;        // seconds
    Eigen::MatrixXd normal;      // (5+B) x (5+B), metres
    Eigen::VectorXd right_side;  // 5+B, of yaw and lambda
    Eigen::VectorXd of_cameras;  // 5+B, the right side that the cameras give, times u
    // With h the camera's position, d what was measured and P its information: the sums of h^T P h and h^T P
    // d.
    double camera_squares = 0, camera_products = 0;
    Eigen::VectorXd state;       // 4+B: q, yaw, lambda
    Eigen::MatrixXd covariance;  // (4+B) x (4+B), given u
    Eigen::VectorXd by_units;    // 4+B: derivative of the state by u
    Eigen::Vector3d up_odom{0, -1, 0};
    YawBelief belief;

    int unknowns() const { return 4 + static_cast<int>(model->modes()); }
  };
  struct Pair {
    double agreement = 0;
    size_t view = 0, track = 0;
  };
  std::vector<Pair> PairWithViews(double timestamp, const std::vector<ObjectView>& views,
                                  const Eigen::Isometry3d& T_odom_camera) const;
  Track& AddTrack(const CategoryModel& model);
  const Track* FindTrack(int id) const;
  void SolveTrack(Track& track) const;
  void GuessUnit();
  PoseAndShape Expected(const Track& track, const Eigen::Isometry3d& T_odom_camera,
                        const Eigen::Vector3d& up_odom) const;
  void Accumulate(Track& track, const SingleViewResult& result, const Eigen::Isometry3d& T_odom_camera);
  void LearnUnit(const Track& track, const Eigen::Isometry3d& T_odom_camera, double distance,
                 const Eigen::Vector3d& ray_odom, double variance_along);
  void UpdateBelief(Track& track, const ObjectView& view, const SingleViewResult& result,
                    const Eigen::Isometry3d& T_odom_camera) const;
  void TurnToBelief(Track& track) const;

  TrackOptions options_;
  std::vector<Track> tracks_;
  int started_ = 0;  // tracks so far: the next id
  OdometryUnit unit_;
};

}  // namespace armature
