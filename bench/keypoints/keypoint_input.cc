// SPDX-License-Identifier: BSD-3-Clause
#include "bench/keypoints/keypoint_input.h"

#include <opencv2/calib3d.hpp>
#include <optional>
#include <utility>

#include "association/box_constraints.h"
#include "bench/keypoints/heat_maps.h"
#include "bench/keypoints/keypoint_resection.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

constexpr double kTurn = 10 * kDegree;  // standard deviations
constexpr double kNoise = 1.5;          // pixels
constexpr double kNearest = 0.05;       // metres

constexpr std::uint64_t kSeed = 1;

std::optional<Eigen::Vector3d> EstimateUp(const BenchSequence& sequence, const FrameInput& input) {
  if (!sequence.up_odom || !input.T_odom_camera) return std::nullopt;
  return (input.T_odom_camera->linear().transpose() * *sequence.up_odom).normalized();
}

KeypointInput MakeInput(const Detection& detection, const KeypointCategory& category, const Camera& camera,
                        const std::optional<Eigen::Vector3d>& up_camera, Random& random) {
  KeypointInput input;
  input.view.camera = &camera;
  input.view.model = &category.model;
  input.view.detection = detection;
  input.view.detection.box = UndistortBox(camera, detection.box);
  input.view.sides = SidesAtImageBorder(input.view.detection.box, camera);
  input.view.up_camera = up_camera;
  input.keypoints = &category.keypoints;
  input.crop = CropAround(detection.box);
  input.maps = DrawHeatMaps(DrawnKeypoints(input.view, category.keypoints, random), input.crop);
  return input;
}

}  // namespace

KeypointCategories MakeKeypointCategories(std::vector<CategoryModel> models) {
  KeypointCategories categories;
  for (CategoryModel& model : models) {
    const std::string name = model.spec.name;
    std::vector<ShapePoint> keypoints = MakeKeypoints(model);
    categories.emplace(name, KeypointCategory{std::move(model), std::move(keypoints)});
  }
  return categories;
}

KeypointInputs MakeKeypointInputs(const BenchSequence& sequence, const KeypointCategories& categories) {
  KeypointInputs inputs;
  std::uint64_t stream = 0;
  for (const BenchFrame& frame : sequence.frames) {
    const std::optional<Eigen::Vector3d> up_camera = EstimateUp(sequence, frame.input);
    std::vector<KeypointInput>& of_frame = inputs[&frame];
    for (const Detection& detection : frame.input.detections) {
      Random random(StreamSeed(kSeed, stream++));
      of_frame.push_back(
          MakeInput(detection, categories.at(detection.category), sequence.camera, up_camera, random));
    }
  }
  return inputs;
}

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
