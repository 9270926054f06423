// SPDX-License-Identifier: BSD-3-Clause
#include "bench/detector_bench.h"

#include <chrono>
#include <memory>

namespace armature {
namespace {

struct TimedDetector {
  std::unique_ptr<LineDetector> detector;
  DetectorTiming timing;
};

std::vector<Segment> Detect(TimedDetector& engine, const BenchImage& image, const Camera& camera) {
  return DetectSegments(*engine.detector, image.gray, camera, image.boxes, engine.timing.options);
}

void Measure(TimedDetector& engine, const BenchImage& image, const Camera& camera) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Segment> segments = Detect(engine, image, camera);
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
  engine.timing.milliseconds.push_back(elapsed.count());
  engine.timing.segments.push_back(static_cast<double>(segments.size()));
  for (const ImageObject& object : image.objects) {
    EdgeRecall& recall = engine.timing.recall[object.category];
    for (const VisibleEdge& edge : object.edges) {
      recall.visible += edge.visible_length();
      recall.covered += CoveredLength(edge, segments, {});
    }
  }
}

}  // namespace

std::vector<LineOptions> AllDetectors() {
  std::vector<LineOptions> all;
  for (const std::string& name : LineDetectorNames()) {
    for (const bool published : {false, true}) {
      LineOptions options;
      options.detector = name;
      options.published = published;
      all.push_back(options);
    }
  }
  return all;
}

std::vector<DetectorTiming> BenchDetectors(const std::vector<BenchImage>& images, const Camera& camera,
                                           const std::vector<LineOptions>& detectors, int warm_up) {
  std::vector<TimedDetector> engines;
  engines.reserve(detectors.size());
  for (const LineOptions& options : detectors)
    engines.push_back({MakeLineDetector(options), {options, {}, {}, {}}});
  for (TimedDetector& engine : engines) {
    for (int i = 0; i < warm_up && !images.empty(); ++i) Detect(engine, images.front(), camera);
  }
  for (size_t i = 0; i < images.size(); ++i) {
    for (size_t k = 0; k < engines.size(); ++k) Measure(engines[(i + k) % engines.size()], images[i], camera);
  }
  std::vector<DetectorTiming> timings;
  timings.reserve(engines.size());
  for (TimedDetector& engine : engines) timings.push_back(std::move(engine.timing));
  return timings;
}

}  // namespace armature
