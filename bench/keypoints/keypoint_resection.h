// SPDX-License-Identifier: BSD-3-Clause
// Pose and shape of an object from keypoints, for the comparison with lines: the least-squares problem, the
// solver and its settings are those of resection/line_resection.h, and so are the up term and the shape's
// regulariser; a keypoint's two coordinates stand in for a segment's ends.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "association/object_view.h"
#include "resection/line_resection.h"
#include "resection/resection_problem.h"

namespace armature {

// The ends of the category's edges, each corner once: ends that lie within 2 cm of each other on the mean
// shape are one keypoint, their mean.
std::vector<ShapePoint> MakeKeypoints(const CategoryModel& model);

// Where they are in the camera frame, 3 x K, metres.
Eigen::Matrix3Xd KeypointsAt(const std::vector<ShapePoint>& keypoints, const PoseAndShape& at);

struct SeenKeypoint {
  int keypoint = 0;             // index into MakeKeypoints
  Eigen::Vector2d pixel{0, 0};  // undistorted
};

// The mean shape, placed by the detection's azimuth (0 without), the up direction and the box: where the
// lines' hypotheses start as well. Without an up direction, elevation and tilt are the detection's.
PoseAndShape PoseFromBox(const ObjectView& view);

// Pose and shape together, from `start`, in three rounds with an ever narrower loss, as the start may be tens
// of pixels off. Of the options, segment_sigma is a coordinate's deviation; the box, the floor and what is
// remembered are not used.
ResectionResult ResectKeypoints(const ObjectView& view, const std::vector<ShapePoint>& keypoints,
                                const std::vector<SeenKeypoint>& seen, const PoseAndShape& start,
                                const ResectionOptions& options);

}  // namespace armature
