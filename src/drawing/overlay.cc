// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>

#include "category/category_lookup.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

constexpr double kNear = 0.05;       // metres
constexpr double kBorder = 50;       // pixels that may be drawn outside the image
constexpr int kShift = 4;            // fractional bits of drawn coordinates
constexpr double kBrightness = 0.7;  // of the image behind the drawing
const cv::Scalar kSegmentColour(150, 150, 150);
const cv::Scalar kBoxColour(255, 200, 0);
const cv::Scalar kBeforeColour(235, 190, 235);
const cv::Scalar kAfterColour(60, 230, 60);
const cv::Scalar kDark(0, 0, 0);

// Clearly different colours (BGR) for the edges of a category, repeated when there are more edges.
cv::Scalar EdgeColour(int edge) {
  static const std::array<cv::Scalar, 12> colours{{{75, 25, 230},
                                                   {0, 225, 255},
                                                   {200, 130, 0},
                                                   {48, 130, 245},
                                                   {180, 30, 145},
                                                   {240, 240, 70},
                                                   {230, 50, 240},
                                                   {60, 245, 210},
                                                   {190, 190, 250},
                                                   {40, 110, 170},
                                                   {0, 128, 128},
                                                   {255, 190, 220}}};
  return colours[static_cast<size_t>(edge) % colours.size()];
}

Box DrawableArea(const cv::Mat& image) {
  return Box{0, 0, static_cast<double>(image.cols), static_cast<double>(image.rows)}.Grown(kBorder);
}

cv::Point Shifted(const Eigen::Vector2d& pixel) {
  const double scale = 1 << kShift;
  return {static_cast<int>(std::lround(pixel.x() * scale)), static_cast<int>(std::lround(pixel.y() * scale))};
}

void DrawSegment(const Segment& segment, const cv::Scalar& colour, int thickness, cv::Mat* image) {
  if (!segment.p1.allFinite() || !segment.p2.allFinite()) return;
  const std::optional<Segment> drawn = Clipped(segment, DrawableArea(*image));
  if (!drawn) return;
  cv::line(*image, Shifted(drawn->p1), Shifted(drawn->p2), colour, thickness, cv::LINE_AA, kShift);
}

void DrawText(const std::string& text, cv::Point at, cv::Mat* image) {
  constexpr double kScale = 0.42;
  const cv::Size size = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, kScale, 1, nullptr);
  at.x = std::max(2, std::min(at.x, image->cols - size.width - 2));
  at.y = std::max(size.height + 2, std::min(at.y, image->rows - 4));
  cv::putText(*image, text, at, cv::FONT_HERSHEY_SIMPLEX, kScale, kDark, 3, cv::LINE_AA);
  cv::putText(*image, text, at, cv::FONT_HERSHEY_SIMPLEX, kScale, cv::Scalar(255, 255, 255), 1, cv::LINE_AA);
}

// Both ends in front of the near plane; none when the whole line is behind it.
std::optional<std::array<Eigen::Vector3d, 2>> CutAtNearPlane(Eigen::Vector3d a, Eigen::Vector3d b) {
  if (!a.allFinite() || !b.allFinite() || (a.z() <= kNear && b.z() <= kNear)) return std::nullopt;
  if (a.z() <= kNear) a = b + (a - b) * (b.z() - kNear) / (b.z() - a.z());
  if (b.z() <= kNear) b = a + (b - a) * (a.z() - kNear) / (a.z() - b.z());
  return std::array{a, b};
}

void DrawBox(const Box& box, cv::Mat* image) {
  const Eigen::Vector2d left_top(box.left(), box.top()), right_top(box.right(), box.top());
  const Eigen::Vector2d left_bottom(box.left(), box.bottom()), right_bottom(box.right(), box.bottom());
  for (const Segment& side : {Segment{left_top, right_top}, Segment{right_top, right_bottom},
                              Segment{right_bottom, left_bottom}, Segment{left_bottom, left_top}}) {
    DrawSegment(side, kBoxColour, 1, image);
  }
}

void DrawWireframes(const ObjectObservation& observation, const CategoryModel& model, const Camera& camera,
                    cv::Mat* image) {
  if (observation.coefficients_initial.size() > 0) {
    const Wireframe before = WireframeFromCoefficients(model, observation.coefficients_initial);
    for (const Segment& edge : ProjectedEdges(before, observation.T_camera_object_initial, camera)) {
      DrawSegment(edge, kBeforeColour, 1, image);
    }
  }
  if (observation.estimate.status != EstimateStatus::kOk) return;
  const Wireframe after = WireframeFromCoefficients(model, observation.estimate.coefficients);
  const std::vector<Segment> edges = ProjectedEdges(after, observation.estimate.T_camera_object, camera);
  for (const Segment& edge : edges) DrawSegment(edge, kDark, 4, image);
  for (const Segment& edge : edges) DrawSegment(edge, kAfterColour, 2, image);
}

std::string Label(const ObjectObservation& observation) {
  const ObjectEstimate& estimate = observation.estimate;
  if (estimate.status != EstimateStatus::kOk) {
    return fmt::format("{} {}", observation.detection.category, StatusName(estimate.status));
  }
  const Eigen::Vector3d centre = estimate.T_camera_object.translation();
  const double azimuth = ViewpointFromRotation(estimate.T_camera_object.linear(), centre).azimuth;
  return fmt::format("{} {:.0f} deg{} {:.2f} m {}", observation.detection.category,
                     azimuth * 180 / std::numbers::pi, estimate.ambiguous ? "?" : "", centre.norm(),
                     StatusName(estimate.status));
}

void DrawObservation(const ObjectObservation& observation, const CategoryModel* model, const Camera& camera,
                     cv::Mat* image) {
  DrawBox(observation.detection.box, image);
  if (model != nullptr) DrawWireframes(observation, *model, camera, image);
  for (const EdgeMatch& match : observation.estimate.matches) {
    DrawSegment(match.segment, EdgeColour(match.edge), 2, image);
  }
}

cv::Mat Dimmed(const cv::Mat& image) {
  cv::Mat canvas;
  if (image.channels() == 1) {
    cv::cvtColor(image, canvas, cv::COLOR_GRAY2BGR);
  } else {
    canvas = image;
  }
  return canvas * kBrightness;
}

}  // namespace

std::vector<Segment> ProjectedEdges(const Wireframe& wireframe, const Eigen::Isometry3d& T_camera_object,
                                    const Camera& camera) {
  std::vector<Segment> segments;
  for (int edge = 0; edge < wireframe.edges(); ++edge) {
    const auto ends =
        CutAtNearPlane(T_camera_object * wireframe.End(edge, 0), T_camera_object * wireframe.End(edge, 1));
    if (!ends) continue;
    const Segment segment{camera.Project((*ends)[0]), camera.Project((*ends)[1])};
    const Box area{0, 0, static_cast<double>(camera.width), static_cast<double>(camera.height)};
    if (const std::optional<Segment> visible = Clipped(segment, area.Grown(kBorder)))
      segments.push_back(*visible);
  }
  return segments;
}

cv::Mat DrawOverlay(const cv::Mat& image, const FrameResult& frame, const std::vector<CategoryModel>& models,
                    const Camera& camera) {
  cv::Mat canvas = Dimmed(image);
  for (const Segment& segment : frame.segments) DrawSegment(segment, kSegmentColour, 1, &canvas);
  for (const ObjectObservation& observation : frame.observations) {
    DrawObservation(observation, FindModel(models, observation.detection.category), camera, &canvas);
  }
  for (const ObjectObservation& observation : frame.observations) {
    const Box& box = observation.detection.box;
    DrawText(Label(observation), {static_cast<int>(box.left()), static_cast<int>(box.top()) - 4}, &canvas);
  }
  return canvas;
}

}  // namespace armature
