// SPDX-License-Identifier: BSD-3-Clause
// All that the keypoint baseline knows of a sequence's detections, made ready before any clock starts.
#pragma once

#include <Eigen/Core>
#include <map>
#include <opencv2/core.hpp>
#include <string>
#include <unordered_map>
#include <vector>

#include "association/object_view.h"
#include "bench/engine.h"
#include "category/category_model.h"
#include "geometry/random.h"
#include "resection/resection_problem.h"

namespace armature {

// Where the lens moves the undistorted pixel to: the inverse of UndistortPixel.
Eigen::Vector2d DistortPixel(const Camera& camera, const Eigen::Vector2d& pixel);

// Pixels, in the image as it is, of the keypoints of the category's mean shape, placed by the box and turned
// by about 10 degrees from the detection's azimuth, as viewpoint priors are off; 1.5 pixels of noise on each
// coordinate. A keypoint behind the camera is far outside of the image.
std::vector<Eigen::Vector2d> DrawnKeypoints(const ObjectView& view, const std::vector<ShapePoint>& keypoints,
                                            Random& random);

struct KeypointCategory {
  CategoryModel model;
  std::vector<ShapePoint> keypoints;
};

using KeypointCategories = std::map<std::string, KeypointCategory>;  // by name

KeypointCategories MakeKeypointCategories(std::vector<CategoryModel> models);

// What is known of a detection before its network runs, and what the network is going to say.
struct KeypointInput {
  ObjectView view;  // points into the sequence and the categories
  const std::vector<ShapePoint>* keypoints = nullptr;
  Box crop;      // pixels of the image as it is
  cv::Mat maps;  // drawn, see DrawnKeypoints; 8 bits a value, as floats of a long sequence fill 100 MB
};

using KeypointInputs = std::unordered_map<const BenchFrame*, std::vector<KeypointInput>>;  // one a detection

// Every detection's category must be one of the categories. A side of a box that is as close to the image's
// border as `cut_tolerance` (share of the box's size) is taken to be cut by it.
KeypointInputs MakeKeypointInputs(const BenchSequence& sequence, const KeypointCategories& categories);

}  // namespace armature
