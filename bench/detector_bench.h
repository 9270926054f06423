// SPDX-License-Identifier: BSD-3-Clause
// Line detectors compared: how long each takes an image, and how much of the true edges it finds.
#pragma once

#include <map>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "eval/visible_edges.h"
#include "geometry/camera.h"
#include "lines/line_detector.h"

namespace armature {

// The true edges of one detected object in one image.
struct ImageObject {
  std::string category;
  std::vector<VisibleEdge> edges;
};

struct BenchImage {
  cv::Mat gray;                      // 8 bit, one channel, as it is (distorted)
  std::vector<Box> boxes;            // of the detections, for boxes_only
  std::vector<ImageObject> objects;  // those whose own edges are known
};

// Pixels of true visible edges.
struct EdgeRecall {
  double visible = 0;
  double covered = 0;  // beside which some segment runs, see CoveredLength of eval/visible_edges.h
};

struct DetectorTiming {
  LineOptions options;
  std::vector<double> milliseconds;          // one an image
  std::vector<double> segments;              // one an image
  std::map<std::string, EdgeRecall> recall;  // by category
};

// Every detector with its tuned and its published parameters.
std::vector<LineOptions> AllDetectors();

// Times DetectSegments: each image by every detector in turn, so that all suffer alike from what else the
// machine does; the turn begins with another detector each image. Before, every detector sees the first image
// `warm_up` times.
std::vector<DetectorTiming> BenchDetectors(const std::vector<BenchImage>& images, const Camera& camera,
                                           const std::vector<LineOptions>& detectors, int warm_up = 3);

}  // namespace armature
