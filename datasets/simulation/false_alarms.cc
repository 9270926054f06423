// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulation/false_alarms.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/rotation.h"

namespace armature {
namespace {

// An upright object that is turned by the angle, counter-clockwise seen from above.
Eigen::Matrix3d UprightInWorld(double yaw) {
  Eigen::Matrix3d R_world_object;
  R_world_object << std::cos(yaw), 0, std::sin(yaw), std::sin(yaw), 0, -std::cos(yaw), 0, 1, 0;
  return R_world_object;
}

Eigen::Matrix3d DrawUpright(Random& random) {
  return UprightInWorld(random.Uniform(-std::numbers::pi, std::numbers::pi));
}

// The box of something of that size [m] that faces the camera; nothing where less than half of it is in the
// picture.
std::optional<Box> FacingBox(const Eigen::Vector3d& centre_camera, const Eigen::Vector2d& size,
                             const Camera& camera) {
  constexpr double kNear = 0.5;  // metres
  if (centre_camera.z() < kNear) return std::nullopt;
  const Eigen::Vector2d centre = camera.Project(centre_camera);
  const double width = camera.fx * size.x() / centre_camera.z(),
               height = camera.fy * size.y() / centre_camera.z();
  const Box whole{centre.x() - 0.5 * width, centre.y() - 0.5 * height, width, height};
  const Box seen = Intersection(whole, ImageBox(camera));
  if (seen.area() < 0.5 * whole.area()) return std::nullopt;
  return seen;
}

}  // namespace

Detection RandomFalseAlarm(const DetectableScene& scene, Random& random) {
  const Camera& camera = scene.camera;
  Detection detection;
  const auto pick = static_cast<size_t>(random.Uniform(0, static_cast<double>(scene.objects.size())));
  detection.category = scene.objects[pick].category;
  const double width = random.Uniform(0.05, 0.3) * camera.width, height = width * random.Uniform(0.6, 1.6);
  const Box box{random.Uniform(-0.5, camera.width - width),
                random.Uniform(-0.5, camera.height - 0.5 * height), width, height};
  detection.box = Intersection(box, ImageBox(camera));
  detection.score = random.Uniform(0.3, 0.7);
  detection.azimuth = random.Uniform(-180, 180) * kDegree;
  detection.elevation = random.Uniform(5, 30) * kDegree;
  detection.tilt = random.Normal(0, 3 * kDegree);
  return detection;
}

int DrawCount(double mean, Random& random) {
  const double whole = std::floor(mean);
  return static_cast<int>(whole) + (random.Uniform(0, 1) < mean - whole ? 1 : 0);
}

DistractorDetector::DistractorDetector(const std::string& shape, std::uint64_t seed)
    : category_(LooksLike(shape)),
      random_(seed),
      R_world_object_(DrawUpright(random_)),
      box_(seed + 1),
      viewpoint_(seed + 2) {}

std::optional<Detection> DistractorDetector::Detect(const SeenFrame& frame, const VisibleObject& seen,
                                                    const DetectableScene& scene,
                                                    const DetectorNoise& noise) {
  if (category_.empty()) return std::nullopt;
  const DetectionNoise& n = noise.Of(category_);
  if (!IsDetectable(seen, n)) return std::nullopt;
  if (!stretches_.IsOn(n.distractors, n.distractors_seconds, frame.timestamp, random_)) return std::nullopt;
  Detection detection;
  detection.category = category_;
  detection.box = box_.Apply(seen.box, n, frame.timestamp, scene.camera, random_);
  if (!IsBox(detection.box)) return std::nullopt;
  detection.score = n.score + random_.Uniform(0, 0.2) + 0.5 * n.score_visible * seen.visible_share;
  viewpoint_.Apply(frame.T_world_camera.linear().transpose() * R_world_object_, scene.camera, n,
                   frame.timestamp, random_, &detection);
  return detection;
}

void BackgroundAlarms::Begin(const SeenFrame& frame, const Camera& camera, const DetectionNoise& noise) {
  const double passed = last_time_ ? frame.timestamp - *last_time_ : 0;
  const double seconds = noise.lasting_alarms_seconds;
  // As many as end meanwhile; all of them at the start.
  const double renewed = last_time_ && seconds > 0 ? 1 - std::exp(-passed / seconds) : 1;
  last_time_ = frame.timestamp;
  for (int i = DrawCount(noise.lasting_alarms * renewed, random_); i > 0; --i) {
    const Eigen::Vector2d pixel(random_.Uniform(0, camera.width), random_.Uniform(0, camera.height));
    const Eigen::Vector3d ray = camera.Ray(pixel);
    const double depth = random_.Uniform(1.5, 5), size = random_.Uniform(0.5, 1.2);
    const double until = frame.timestamp - seconds * std::log(1 - random_.Uniform(0, 1));
    const auto seed = static_cast<std::uint64_t>(random_.Uniform(0, 1e15));
    alarms_.push_back({until, frame.T_world_camera * (ray / ray.z() * depth),
                       Eigen::Vector2d(size, size * random_.Uniform(0.6, 1.2)), DrawUpright(random_),
                       BoxErrors(seed), ViewpointErrors(seed + 1)});
  }
}

std::vector<Detection> BackgroundAlarms::Detect(const SeenFrame& frame, const DetectableScene& scene,
                                                const DetectionNoise& noise) {
  std::erase_if(alarms_, [&](const Alarm& alarm) { return alarm.until <= frame.timestamp; });
  Begin(frame, scene.camera, noise);
  std::vector<Detection> found;
  for (Alarm& alarm : alarms_) {
    const std::optional<Box> box =
        FacingBox(frame.T_world_camera.inverse() * alarm.centre_world, alarm.size, scene.camera);
    if (!box) continue;
    Detection detection;
    detection.category = category_;
    detection.box = alarm.box.Apply(*box, noise, frame.timestamp, scene.camera, random_);
    if (!IsBox(detection.box)) continue;
    detection.score = noise.score + random_.Uniform(0, 0.2);
    alarm.viewpoint.Apply(frame.T_world_camera.linear().transpose() * alarm.R_world_object, scene.camera,
                          noise, frame.timestamp, random_, &detection);
    found.push_back(detection);
  }
  return found;
}

}  // namespace armature
