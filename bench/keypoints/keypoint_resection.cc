// SPDX-License-Identifier: BSD-3-Clause
#include "bench/keypoints/keypoint_resection.h"

#include <algorithm>

#include "association/box_constraints.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

constexpr double kSameCorner = 0.02;  // metres

// Ends of edges that are one corner.
struct Corner {
  ShapePoint first;
  ShapePoint sum;
  double ends = 1;
};

void AddEnd(const ShapePoint& end, std::vector<Corner>& corners) {
  const auto same = std::find_if(corners.begin(), corners.end(), [&](const Corner& corner) {
    return (corner.first.X0 - end.X0).norm() < kSameCorner;
  });
  if (same == corners.end()) {
    corners.push_back({end, end});
    return;
  }
  same->sum.X0 += end.X0;
  same->sum.G += end.G;
  same->ends += 1;
}

ResectionProblem MakeProblem(const ObjectView& view, const std::vector<ShapePoint>& keypoints,
                             const std::vector<SeenKeypoint>& seen, const PoseAndShape& start,
                             const ResectionOptions& options, double loss_scale) {
  ResectionProblem problem;
  problem.camera = view.camera;
  problem.model = view.model;
  problem.R0 = start.T_camera_object.linear();
  problem.T0 = start.T_camera_object.translation();
  problem.shape_weight = options.shape_weight;
  problem.normal_term = view.up_camera ? NormalTerm::kAxis : NormalTerm::kNone;
  problem.up_camera = view.up_camera.value_or(problem.up_camera);
  problem.up_weight = 1 / (options.up_sigma_deg * kDegree);
  problem.line_terms.reserve(2 * seen.size());
  const double weight = 1 / options.segment_sigma;
  for (const auto& [index, pixel] : seen) {  // on the image's vertical and its horizontal through the pixel
    const ShapePoint& point = keypoints[static_cast<size_t>(index)];
    problem.line_terms.push_back({point, {1, 0, -pixel.x()}, weight, loss_scale, false});
    problem.line_terms.push_back({point, {0, 1, -pixel.y()}, weight, loss_scale, false});
  }
  return problem;
}

}  // namespace

std::vector<ShapePoint> MakeKeypoints(const CategoryModel& model) {
  std::vector<Corner> corners;
  for (int edge = 0; edge < model.spec.edges(); ++edge) {
    for (const double s : {-0.5, 0.5}) AddEnd(PointOnEdge(model, edge, s), corners);
  }
  std::vector<ShapePoint> keypoints;
  keypoints.reserve(corners.size());
  for (const Corner& corner : corners) {
    keypoints.push_back({corner.sum.X0 / corner.ends, corner.sum.G / corner.ends});
  }
  return keypoints;
}

Eigen::Matrix3Xd KeypointsAt(const std::vector<ShapePoint>& keypoints, const PoseAndShape& at) {
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(keypoints.size()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const ShapePoint& keypoint = keypoints[static_cast<size_t>(i)];
    points.col(i) = at.T_camera_object * (keypoint.X0 + keypoint.G * at.coefficients);
  }
  return points;
}

PoseAndShape PoseFromBox(const ObjectView& view) {
  const Detection& detection = view.detection;
  const Eigen::Vector3d ray = view.camera->Ray(detection.box.center());
  const double azimuth = detection.azimuth.value_or(0);
  const Eigen::Matrix3d R =
      view.up_camera ? UprightRotation(azimuth, *view.up_camera, ray)
                     : RotationFromViewpoint(
                           {azimuth, detection.elevation.value_or(0), detection.tilt.value_or(0)}, ray);
  PoseAndShape pose;
  pose.coefficients = Eigen::VectorXd::Zero(view.model->modes());
  pose.T_camera_object.linear() = R;
  pose.T_camera_object.translation() =
      TranslationFromBox(view, view.sides, WireframeFromVector(view.model->mean), R);
  return pose;
}

ResectionResult ResectKeypoints(const ObjectView& view, const std::vector<ShapePoint>& keypoints,
                                const std::vector<SeenKeypoint>& seen, const PoseAndShape& start,
                                const ResectionOptions& options) {
  ResectionResult result{.estimate = start};
  for (const double widening : {16, 4, 1}) {
    ResectionProblem problem =
        MakeProblem(view, keypoints, seen, result.estimate, options, widening * kSegmentLossScale);
    const int iterations = result.iterations;
    result = ResectFrom(problem, result.estimate.coefficients, options);
    result.iterations += iterations;
    if (!result.finite()) break;
  }
  return result;
}

}  // namespace armature
