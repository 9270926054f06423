// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulation/detections.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "datasets/simulation/false_alarms.h"
#include "datasets/simulation/object_detector.h"
#include "geometry/random.h"

namespace armature {
namespace {

// Streams of random numbers beside those of the frames, which are numbered from 0.
enum Beside : std::uint64_t { kObjects = 1ULL << 40, kDistractors, kBackground };

class Detector {
 public:
  Detector(const DetectableScene& scene, const DetectorNoise& noise, std::uint64_t seed)
      : scene_(scene), noise_(noise) {
    const std::uint64_t of_objects = StreamSeed(seed, kObjects),
                        of_distractors = StreamSeed(seed, kDistractors),
                        of_background = StreamSeed(seed, kBackground);
    std::set<std::string> categories;
    for (size_t i = 0; i < scene.objects.size(); ++i) {
      objects_.emplace_back(static_cast<int>(i) + 1, StreamSeed(of_objects, i));
      categories.insert(scene.objects[i].category);
    }
    for (size_t i = 0; i < scene.distractors.size(); ++i)
      distractors_.emplace_back(scene.distractors[i].shape, StreamSeed(of_distractors, i));
    for (const std::string& category : categories)
      background_.push_back({category, {category, StreamSeed(of_background, background_.size())}});
  }

  std::vector<SimulatedDetection> Detect(const SeenFrame& frame, std::uint64_t seed) {
    Random random(seed);
    std::vector<SimulatedDetection> found;
    for (const VisibleObject& seen : frame.visible) DetectSeen(frame, seen, random, &found);
    for (Background& background : background_) {
      for (Detection& alarm : background.alarms.Detect(frame, scene_, noise_.Of(background.category)))
        found.push_back({std::move(alarm), ""});
    }
    for (int i = scene_.objects.empty() ? 0 : DrawCount(noise_.any.false_alarms, random); i > 0; --i)
      found.push_back({RandomFalseAlarm(scene_, random), ""});
    for (SimulatedDetection& detected : found)
      detected.detection.score = std::min(1.0, detected.detection.score);
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.detection.score > b.detection.score; });
    return found;
  }

 private:
  struct Background {
    std::string category;
    BackgroundAlarms alarms;
  };

  void DetectSeen(const SeenFrame& frame, const VisibleObject& seen, Random& random,
                  std::vector<SimulatedDetection>* found) {
    const size_t place = static_cast<size_t>(seen.object) - 1;
    if (place < objects_.size()) {
      std::vector<SimulatedDetection> of_object = objects_[place].Detect(frame, seen, scene_, noise_, random);
      std::move(of_object.begin(), of_object.end(), std::back_inserter(*found));
      return;
    }
    const std::optional<Detection> alarm =
        distractors_[place - objects_.size()].Detect(frame, seen, scene_, noise_);
    if (alarm) found->push_back({*alarm, ""});
  }

  const DetectableScene& scene_;
  const DetectorNoise& noise_;
  std::vector<ObjectDetector> objects_;
  std::vector<DistractorDetector> distractors_;
  std::vector<Background> background_;
};

}  // namespace

std::vector<std::vector<SimulatedDetection>> SimulateDetections(const std::vector<SeenFrame>& frames,
                                                                const DetectableScene& scene,
                                                                const DetectorNoise& noise,
                                                                std::uint64_t seed) {
  Detector detector(scene, noise, seed);
  std::vector<std::vector<SimulatedDetection>> detections;
  for (size_t i = 0; i < frames.size(); ++i)
    detections.push_back(detector.Detect(frames[i], StreamSeed(seed, i)));
  return detections;
}

}  // namespace armature
