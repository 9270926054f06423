// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulation/detections.h"

#include <algorithm>
#include <cmath>

#include "geometry/random.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

constexpr double kLeastBox = 4;  // pixels each way, after the noise

Box ImageBox(const Camera& camera) {
  return {-0.5, -0.5, static_cast<double>(camera.width), static_cast<double>(camera.height)};
}

Box Noisy(const Box& box, double noise, const Camera& camera, Random& random) {
  const double left = random.Normal(box.left(), noise * box.width);
  const double right = random.Normal(box.right(), noise * box.width);
  const double top = random.Normal(box.top(), noise * box.height);
  const double bottom = random.Normal(box.bottom(), noise * box.height);
  return Intersection({left, top, right - left, bottom - top}, ImageBox(camera));
}

void SetViewpoint(const Eigen::Matrix3d& R_camera_object, const Camera& camera, const DetectionNoise& noise,
                  Random& random, Detection* detection) {
  const Viewpoint truth = ViewpointFromRotation(R_camera_object, camera.Ray(detection->box.center()));
  const double turn = random.Uniform(0, 1) < noise.turned ? 180 * kDegree : 0;
  detection->azimuth = WrapAngle(random.Normal(truth.azimuth + turn, noise.azimuth_deg * kDegree));
  detection->elevation = random.Normal(truth.elevation, noise.elevation_deg * kDegree);
  detection->tilt = random.Normal(truth.tilt, noise.tilt_deg * kDegree);
}

bool IsDetectable(const VisibleObject& visible, const DetectionNoise& noise) {
  return visible.visible_share >= noise.min_visible &&
         std::max(visible.box.width, visible.box.height) >= noise.min_size_px;
}

Detection FalseAlarm(const std::vector<DetectableObject>& objects, const Camera& camera, Random& random) {
  Detection detection;
  const auto pick = static_cast<size_t>(random.Uniform(0, static_cast<double>(objects.size())));
  detection.category = objects[pick].category;
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

int FalseAlarms(double mean, Random& random) {
  const double whole = std::floor(mean);
  return static_cast<int>(whole) + (random.Uniform(0, 1) < mean - whole ? 1 : 0);
}

}  // namespace

DetectionNoise DetectionNoise::Times(double factor) const {
  DetectionNoise times = *this;
  for (double* value :
       {&times.box, &times.false_alarms, &times.azimuth_deg, &times.elevation_deg, &times.tilt_deg})
    *value *= factor;
  for (double* share : {&times.missed, &times.turned}) *share = std::min(1.0, *share * factor);
  return times;
}

std::vector<SimulatedDetection> SimulateDetections(const std::vector<VisibleObject>& visible,
                                                   const std::vector<DetectableObject>& objects,
                                                   const Camera& camera,
                                                   const Eigen::Isometry3d& T_world_camera,
                                                   const DetectionNoise& noise, std::uint64_t seed) {
  Random random(seed);
  std::vector<SimulatedDetection> detections;
  for (const VisibleObject& seen : visible) {
    if (!IsDetectable(seen, noise) || random.Uniform(0, 1) < noise.missed) continue;
    const DetectableObject& object = objects[static_cast<size_t>(seen.object) - 1];
    Detection detection;
    detection.category = object.category;
    detection.box = Noisy(seen.box, noise.box, camera, random);
    if (detection.box.width < kLeastBox || detection.box.height < kLeastBox) continue;
    detection.score = random.Uniform(0.4, 0.6) + 0.39 * seen.visible_share;
    SetViewpoint(T_world_camera.linear().transpose() * object.T_world_object.linear(), camera, noise, random,
                 &detection);
    detections.push_back({detection, object.id});
  }
  for (int i = FalseAlarms(noise.false_alarms, random); i > 0; --i) {
    detections.push_back({FalseAlarm(objects, camera, random), ""});
  }
  std::stable_sort(detections.begin(), detections.end(),
                   [](const auto& a, const auto& b) { return a.detection.score > b.detection.score; });
  return detections;
}

}  // namespace armature
