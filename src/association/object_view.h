// SPDX-License-Identifier: BSD-3-Clause
// Everything that one image (and what was learnt from the images before it) says about one detected object:
// the input of association and resection.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <vector>

#include "association/detection.h"
#include "association/projection.h"
#include "category/category_model.h"
#include "geometry/camera.h"
#include "geometry/segment.h"

namespace armature {

// How one side of the box bounds the object's projection.
enum class BoxSide {
  kSeen,  // the object ends there
  kOpen,  // the object ends there or beyond: cut by the image's border, or hidden beyond by something else
};

// Left, top, right, bottom.
using BoxSides = std::array<BoxSide, 4>;

// Where the floor is, known from the objects that stand on it.
struct FloorPrior {
  double camera_height = 0;  // metres, of the camera above the floor along up
  double sigma = 0;          // metres
};

struct PoseAndShape {
  Eigen::Isometry3d T_camera_object = Eigen::Isometry3d::Identity();  // metres
  Eigen::VectorXd coefficients;                                       // standard deviations
};

// What the viewpoint priors of earlier frames say about an object's turn: a cost for each direction that its
// front may have in the horizontal plane.
struct YawBelief {
  static constexpr int kBins = 72;   // of 5 degrees
  std::array<double, kBins> cost{};  // negative log-likelihood, 0 for the best

  // The cost at a yaw in radians, interpolated between the bins' centres.
  double At(double yaw) const;
};

// A value of an TrackPrior's z, or something that belongs to each of its numbers; not on the heap.
using TrackPriorVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 4 + kMaxModes, 1>;

// What earlier frames say about an object that has been seen before: a Gaussian over z = (T, yaw, lambda), 4
// + B numbers, T the object's centre in this camera, yaw the turn about up, lambda the shape's coefficients.
// It is joint because what was seen may be one end of a table: then neither its centre nor its length is
// known, but their difference is.
struct TrackPrior {
  PoseAndShape expected;             // in this camera
  Eigen::MatrixXd information;       // of z, (4+B) x (4+B)
  Eigen::MatrixXd sqrt_information;  // L^T, L L^T the information
  YawBelief belief;                  // of the direction of the object's z axis
  Eigen::Vector3d yaw_zero,
      yaw_quarter;  // the horizontal directions of yaw 0 and 90 degrees, unit, camera frame

  // z - z_expected of a pose and shape; the yaw's difference is taken from the direction of the object's
  // front.
  TrackPriorVector Difference(const Eigen::Matrix3d& R_camera_object, const Eigen::Vector3d& T,
                              const Eigen::Ref<const Eigen::VectorXd>& coefficients) const;
  // The horizontal direction 90 degrees ahead of the expected front: the front's component along it is the
  // yaw's difference to first order.
  Eigen::Vector3d AheadOfFront() const;
};

struct ObjectView {
  const Camera* camera = nullptr;
  const CategoryModel* model = nullptr;  // none: not to be looked at, the detection repeats another
  Detection detection;
  BoxSides sides{};  // of the detection's box
  std::array<double, 4>
      hidden_probability{};       // that something else hides the object beyond each side of its box
  std::vector<Segment> segments;  // undistorted pixels, inside the grown box
  std::optional<Eigen::Vector3d>
      up_camera;                     // unit, camera frame; none: take the viewpoint's elevation and tilt
  std::vector<ImageFace> occluders;  // faces of other objects in this image
  std::optional<FloorPrior> floor;
  std::optional<TrackPrior> track_prior;
};

}  // namespace armature
