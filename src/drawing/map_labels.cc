// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/map_labels.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace armature {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_DUPLEX;
const cv::Scalar kInk(45, 40, 40), kPaper(255, 255, 255);

double FontScale(const cv::Mat3b& picture) { return 0.62 * picture.cols / 1600; }

// In the middle above all of the object that is drawn; pixels.
cv::Point FindTop(const MapSceneObject& object, const MapView& view) {
  const Eigen::Isometry3d T_camera_object = view.T_world_camera.inverse() * object.T_world_object;
  Eigen::AlignedBox2d box(view.camera.Project(T_camera_object.translation()));
  const auto extend = [&](const Eigen::Vector3d& p) { box.extend(view.camera.Project(T_camera_object * p)); };
  for (const auto& vertex : object.cad.vertices.colwise()) extend(vertex);
  for (int edge = 0; edge < object.wireframe.edges(); ++edge) {
    for (int end = 0; end < 2; ++end) extend(object.wireframe.End(edge, end));
  }
  return {cvRound(box.center().x()), cvRound(box.min().y())};
}

// Within the picture, and above those that are already there.
cv::Rect FreePlace(cv::Rect place, const std::vector<cv::Rect>& taken, const cv::Size& picture) {
  place.x = std::clamp(place.x, 0, std::max(0, picture.width - place.width));
  const auto overlaps = [&](const cv::Rect& other) { return (place & other).area() > 0; };
  for (auto other = taken.begin(); other != taken.end();) {
    if (overlaps(*other)) {
      place.y = other->y - place.height;
      other = taken.begin();
    } else {
      ++other;
    }
  }
  place.y = std::max(place.y, 0);
  return place;
}

}  // namespace

void DrawMapLabels(const MapScene& scene, const MapView& view, cv::Mat3b* picture) {
  const double scale = FontScale(*picture);
  std::vector<cv::Rect> taken;
  for (const MapSceneObject& object : scene.objects) {
    int below = 0;
    const cv::Size size = cv::getTextSize(object.id, kFont, scale, 1, &below);
    const cv::Point top = FindTop(object, view);
    const cv::Size padded(size.width + 8, size.height + below + 4);
    const cv::Point corner(top.x - padded.width / 2, top.y - padded.height - 2);
    const cv::Rect place = FreePlace({corner, padded}, taken, picture->size());
    taken.push_back(place);
    const cv::Point text(place.x + 4, place.y + 2 + size.height);
    cv::putText(*picture, object.id, text, kFont, scale, kPaper, 4, cv::LINE_AA);
    cv::putText(*picture, object.id, text, kFont, scale, kInk, 1, cv::LINE_AA);
  }
}

}  // namespace armature
