// SPDX-License-Identifier: BSD-3-Clause
// Everything that one image (and what was learnt from the images before it) says about one detected object: the input of
// association and resection.
#pragma once

#include <Eigen/Geometry>
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

struct ObjectView {
  const Camera* camera = nullptr;
  const CategoryModel* model = nullptr;
  Detection detection;
  BoxSides sides{};               // of the detection's box
  std::vector<Segment> segments;  // undistorted pixels, inside the grown box
  std::optional<Eigen::Vector3d> up_camera;  // unit, camera frame; none: take the viewpoint's elevation and tilt
  std::vector<ImageFace> occluders;          // faces of other objects in this image
  std::optional<FloorPrior> floor;
  std::vector<PoseAndShape> seeds;  // to try besides those that the box suggests, e.g. from the image before
};

}  // namespace armature
