// SPDX-License-Identifier: BSD-3-Clause
#include "eval/detections/matched_detections.h"

#include <algorithm>
#include <numeric>

namespace armature {
namespace {

constexpr double kLeastOverlap = 0.5;  // as Pascal VOC has it

double Overlap(const Detection& detection, const TrueBox& seen) {
  return std::max(IntersectionOverUnion(detection.box, seen.visible),
                  IntersectionOverUnion(detection.box, seen.whole));
}

std::vector<size_t> ByFallingScore(const std::vector<Detection>& detections) {
  std::vector<size_t> order(detections.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return detections[a].score > detections[b].score; });
  return order;
}

// The one of those that are eligible which the detection overlaps most, and by how much.
template <typename IsEligible>
MatchedDetection Best(const Detection& detection, const std::vector<TrueBox>& seen, DetectionVerdict verdict,
                      const IsEligible& is_eligible) {
  MatchedDetection best;
  for (size_t i = 0; i < seen.size(); ++i) {
    const double iou = Overlap(detection, seen[i]);
    if (iou < kLeastOverlap || iou <= best.iou || !is_eligible(i)) continue;
    best = {verdict, i, iou};
  }
  return best;
}

}  // namespace

bool IsAskedFor(const TrueBox& seen) {
  constexpr double kLeastShare = 0.3, kLeastSize = 24;  // of the edges; pixels, of the larger side
  return seen.share >= kLeastShare && std::max(seen.visible.width, seen.visible.height) >= kLeastSize;
}

std::vector<MatchedDetection> MatchDetections(const std::vector<Detection>& detections,
                                              const std::vector<TrueBox>& seen,
                                              const std::vector<std::string>& categories) {
  std::vector<MatchedDetection> matched(detections.size());
  std::vector<bool> is_taken(seen.size(), false);
  for (const size_t d : ByFallingScore(detections)) {
    const Detection& detection = detections[d];
    const auto is_alike = [&](size_t i) { return categories[seen[i].object] == detection.category; };
    MatchedDetection& match = matched[d];
    match = Best(detection, seen, DetectionVerdict::kRight,
                 [&](size_t i) { return is_alike(i) && !is_taken[i] && IsAskedFor(seen[i]); });
    if (match.seen) is_taken[*match.seen] = true;
    if (!match.seen)
      match = Best(detection, seen, DetectionVerdict::kDuplicate,
                   [&](size_t i) { return is_alike(i) && is_taken[i]; });
    if (!match.seen) match = Best(detection, seen, DetectionVerdict::kNotJudged, is_alike);
    if (!match.seen)
      match = Best(detection, seen, DetectionVerdict::kWrongCategory, [](size_t) { return true; });
  }
  return matched;
}

}  // namespace armature
