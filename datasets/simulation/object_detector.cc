// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulation/object_detector.h"

#include <algorithm>
#include <cmath>

namespace armature {
namespace {

// Streams of random numbers of an object.
enum ObjectStream : std::uint64_t { kOwn = 1, kPart, kBox, kViewpoint, kDuplicate, kMistaken, kDifficulty };

// A duplicate's sides are this much farther off than those of the first box.
constexpr double kDuplicateBox = 3;

Eigen::Matrix3d RotationInCamera(const SeenFrame& frame, const DetectableObject& object) {
  return frame.T_world_camera.linear().transpose() * object.T_world_object.linear();
}

// Whether the chair stands at the table: its middle is above the table's footprint or near it.
bool StandsAt(const DetectableObject& chair, const DetectableObject& table) {
  constexpr double kReach = 0.45;  // metres: half a chair, pulled out a little
  const Eigen::Vector3d from_table = table.T_world_object.inverse() * chair.T_world_object.translation();
  return std::abs(from_table.x()) < 0.5 * table.size.x() + kReach &&
         std::abs(from_table.z()) < 0.5 * table.size.z() + kReach;
}

// Around the table and what is seen of the chairs at it.
Box SpanningBox(const Box& box, const DetectableObject& table, const SeenFrame& frame,
                const DetectableScene& scene) {
  Box spanning = box;
  for (const VisibleObject& seen : frame.visible) {
    const auto place = static_cast<size_t>(seen.object) - 1;
    if (place >= scene.objects.size() || scene.objects[place].category != "chair") continue;
    if (StandsAt(scene.objects[place], table)) spanning = Union(spanning, seen.box);
  }
  return spanning;
}

// What the detector takes for an object of the other category: of a chair the seat and what is below it, as
// if it were a table.
Box MistakenBox(const Box& box, const std::string& category) {
  constexpr double kBack = 0.3;  // share of a chair's box
  if (category != "chair") return box;
  return {box.x, box.y + kBack * box.height, box.width, (1 - kBack) * box.height};
}

SimulatedDetection Named(const std::string& category, const std::string& id) {
  SimulatedDetection detection;
  detection.detection.category = category;
  detection.id = id;
  return detection;
}

double LogOdds(double share) { return std::log(share / (1 - share)); }

}  // namespace

bool IsDetectable(const VisibleObject& visible, const DetectionNoise& noise) {
  return visible.visible_share >= noise.min_visible &&
         std::max(visible.box.width, visible.box.height) >= noise.min_size_px;
}

std::string LooksLike(const std::string& category_or_shape) {
  static const std::map<std::string, std::string> kLookAlikes = {
      {"chair", "table"}, {"table", "chair"}, {"laptop", "chair"},
      {"sofa", "chair"},  {"stool", "chair"}, {"cabinet", "table"},
      {"shelf", "table"}, {"plant", "chair"}, {"round_table", "table"}};
  const auto found = kLookAlikes.find(category_or_shape);
  return found == kLookAlikes.end() ? "" : found->second;
}

ObjectDetector::ObjectDetector(int number, std::uint64_t seed)
    : number_(number),
      difficulty_(Random(StreamSeed(seed, kDifficulty)).Normal(0, 1)),
      random_(StreamSeed(seed, kOwn)),
      part_(StreamSeed(seed, kPart)),
      box_(StreamSeed(seed, kBox)),
      viewpoint_(StreamSeed(seed, kViewpoint)),
      duplicate_(StreamSeed(seed, kDuplicate)),
      mistaken_(StreamSeed(seed, kMistaken)) {}

const DetectableObject& ObjectDetector::Object(const DetectableScene& scene) const {
  return scene.objects[static_cast<size_t>(number_) - 1];
}

bool ObjectDetector::IsMissed(const VisibleObject& seen, const DetectionNoise& noise, double time,
                              Random& random) {
  double share = noise.missed;
  const double harder = noise.missed_spread * difficulty_ + noise.missed_hidden * (1 - seen.visible_share);
  if (harder != 0 && share > 0 && share < 1) share = 1 / (1 + std::exp(-LogOdds(share) - harder));
  return missed_.IsOn(share, noise.missed_seconds, time, random);
}

Box ObjectDetector::SeenBox(const SeenFrame& frame, const VisibleObject& seen, const DetectableScene& scene,
                            const DetectionNoise& noise) {
  const Box part = part_.Apply(seen.box, seen.visible_share, noise, frame.timestamp);
  const bool spans = spanning_.IsOn(noise.spanning, noise.spanning_seconds, frame.timestamp, random_);
  if (!spans || Object(scene).category != "table") return part;
  return SpanningBox(part, Object(scene), frame, scene);
}

void ObjectDetector::AddDuplicate(const SeenFrame& frame, const VisibleObject& seen, const Box& box,
                                  const DetectableScene& scene, const DetectionNoise& noise,
                                  std::vector<SimulatedDetection>* found) {
  Extra& extra = duplicate_;
  if (!extra.stretches.IsOn(noise.duplicates, noise.duplicates_seconds, frame.timestamp, extra.random))
    return;
  DetectionNoise larger = noise;
  larger.box *= kDuplicateBox;
  SimulatedDetection duplicate = Named(Object(scene).category, Object(scene).id);
  duplicate.detection.box = extra.box.Apply(box, larger, frame.timestamp, scene.camera, extra.random);
  if (!IsBox(duplicate.detection.box)) return;
  duplicate.detection.score =
      noise.score + extra.random.Uniform(0, 0.2) + 0.5 * noise.score_visible * seen.visible_share;
  extra.viewpoint.Apply(RotationInCamera(frame, Object(scene)), scene.camera, noise, frame.timestamp,
                        extra.random, &duplicate.detection);
  found->push_back(duplicate);
}

void ObjectDetector::AddMistaken(const SeenFrame& frame, const VisibleObject& seen,
                                 const DetectableScene& scene, const DetectorNoise& noise,
                                 std::vector<SimulatedDetection>* found) {
  const std::string category = LooksLike(Object(scene).category);
  Extra& extra = mistaken_;
  const DetectionNoise& own = noise.Of(Object(scene).category);
  if (!extra.stretches.IsOn(own.mistaken, own.mistaken_seconds, frame.timestamp, extra.random)) return;
  const DetectionNoise& taken_for = noise.Of(category);
  SimulatedDetection mistaken = Named(category, "");
  mistaken.detection.box = extra.box.Apply(MistakenBox(seen.box, Object(scene).category), taken_for,
                                           frame.timestamp, scene.camera, extra.random);
  if (!IsBox(mistaken.detection.box)) return;
  mistaken.detection.score = taken_for.score + extra.random.Uniform(0, 0.2);
  extra.viewpoint.Apply(RotationInCamera(frame, Object(scene)), scene.camera, taken_for, frame.timestamp,
                        extra.random, &mistaken.detection);
  found->push_back(mistaken);
}

std::vector<SimulatedDetection> ObjectDetector::Detect(const SeenFrame& frame, const VisibleObject& seen,
                                                       const DetectableScene& scene,
                                                       const DetectorNoise& noise, Random& random) {
  const DetectableObject& object = Object(scene);
  const DetectionNoise& own = noise.Of(object.category);
  std::vector<SimulatedDetection> found;
  if (!IsDetectable(seen, own)) return found;
  AddMistaken(frame, seen, scene, noise, &found);
  const Box box = SeenBox(frame, seen, scene, own);
  if (IsMissed(seen, own, frame.timestamp, random)) return found;
  SimulatedDetection detected = Named(object.category, object.id);
  detected.detection.box = box_.Apply(box, own, frame.timestamp, scene.camera, random);
  if (!IsBox(detected.detection.box)) return found;
  detected.detection.score =
      random.Uniform(own.score, own.score + 0.2) + own.score_visible * seen.visible_share;
  viewpoint_.Apply(RotationInCamera(frame, object), scene.camera, own, frame.timestamp, random,
                   &detected.detection);
  found.push_back(detected);
  AddDuplicate(frame, seen, box, scene, own, &found);
  return found;
}

}  // namespace armature
