// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/camera.h"

#include <algorithm>
#include <opencv2/calib3d.hpp>

namespace armature {

bool Camera::IsDistorted() const {
  return std::any_of(distortion.begin(), distortion.end(), [](double k) { return k != 0; });
}

Eigen::Vector2d UndistortPixel(const Camera& camera, const Eigen::Vector2d& pixel) {
  if (!camera.IsDistorted()) return pixel;
  const cv::Matx33d K(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  const cv::Mat distortion(1, 5, CV_64F, const_cast<double*>(camera.distortion.data()));
  const cv::TermCriteria criteria(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 40, 1e-9);
  cv::Mat_<cv::Vec2d> in(1, 1, cv::Vec2d(pixel.x(), pixel.y()));
  cv::Mat_<cv::Vec2d> out;
  cv::undistortPoints(in, out, K, distortion, cv::noArray(), K, criteria);
  return {out(0)[0], out(0)[1]};
}

Box UndistortBox(const Camera& camera, const Box& box) {
  if (!camera.IsDistorted()) return box;
  const Eigen::Vector2d c = box.center();
  const double left = UndistortPixel(camera, {box.left(), c.y()}).x();
  const double right = UndistortPixel(camera, {box.right(), c.y()}).x();
  const double top = UndistortPixel(camera, {c.x(), box.top()}).y();
  const double bottom = UndistortPixel(camera, {c.x(), box.bottom()}).y();
  return {left, top, right - left, bottom - top};
}

}  // namespace armature
