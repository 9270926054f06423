// SPDX-License-Identifier: BSD-3-Clause
#include "bench/keypoints/drawn_keypoints.h"

#include <opencv2/calib3d.hpp>

#include "bench/keypoints/keypoint_resection.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

constexpr double kTurn = 10 * kDegree;  // standard deviations
constexpr double kNoise = 1.5;          // pixels
constexpr double kNearest = 0.05;       // metres

}  // namespace

Eigen::Vector2d DistortPixel(const Camera& camera, const Eigen::Vector2d& pixel) {
  if (!camera.IsDistorted()) return pixel;
  const cv::Matx33d K(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  const cv::Mat distortion(1, 5, CV_64F, const_cast<double*>(camera.distortion.data()));
  const Eigen::Vector3d ray = camera.Ray(pixel);
  const std::vector<cv::Point3d> points = {{ray.x(), ray.y(), ray.z()}};
  std::vector<cv::Point2d> distorted;
  cv::projectPoints(points, cv::Vec3d::zeros(), cv::Vec3d::zeros(), K, distortion, distorted);
  return {distorted.front().x, distorted.front().y};
}

std::vector<Eigen::Vector2d> DrawnKeypoints(const ObjectView& view, const std::vector<ShapePoint>& keypoints,
                                            Random& random) {
  PoseAndShape pose = PoseFromBox(view);
  pose.T_camera_object.rotate(Eigen::AngleAxisd(random.Normal(0, kTurn), Eigen::Vector3d::UnitY()));
  std::vector<Eigen::Vector2d> pixels;
  const Eigen::Matrix3Xd points = KeypointsAt(keypoints, pose);
  for (const Eigen::Vector3d point : points.colwise()) {
    Eigen::Vector2d pixel = Eigen::Vector2d::Constant(-1e6);
    if (point.z() > kNearest) pixel = DistortPixel(*view.camera, view.camera->Project(point));
    const double u = random.Normal(pixel.x(), kNoise), v = random.Normal(pixel.y(), kNoise);
    pixels.emplace_back(u, v);
  }
  return pixels;
}

}  // namespace armature
