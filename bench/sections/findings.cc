// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sections/findings.h"

namespace armature {
namespace {

void AddRecall(const TrueDetection& truth, const std::vector<Segment>& segments, Findings& findings) {
  if (!truth.edges) return;
  EdgeRecall& recall = findings.recall[truth.category];
  for (const VisibleEdge& edge : *truth.edges) {
    recall.visible += edge.visible_length();
    recall.covered += CoveredLength(edge, segments, {});
  }
}

}  // namespace

void AddFindings(const FrameTruth& truth, const std::vector<Segment>& segments,
                 const std::vector<ObjectEstimate>& estimates, Findings& findings) {
  for (size_t i = 0; i < truth.size(); ++i) {
    if (!truth[i]) continue;
    ++findings.detections;
    AddRecall(*truth[i], segments, findings);
    if (estimates[i].status != EstimateStatus::kOk) continue;
    findings.errors.push_back(CompareObservation(truth[i]->category, truth[i]->symmetry_order, true,
                                                 estimates[i].T_camera_object, truth[i]->T_camera_object));
  }
}

EdgeRecall AllRecall(const Findings& findings) {
  EdgeRecall all;
  for (const auto& [category, recall] : findings.recall) {
    all.visible += recall.visible;
    all.covered += recall.covered;
  }
  return all;
}

std::optional<Accuracy> ComputeAccuracy(const Findings& findings) {
  if (findings.errors.empty()) return std::nullopt;
  const ObservationSummary summary = Summarise(findings.errors);
  const double with_pose = static_cast<double>(summary.count) / findings.detections;
  return Accuracy{summary.median_azimuth_deg, summary.median_translation_percent,
                  with_pose * summary.share_within_15_deg, with_pose};
}

bool IsAsAccurate(const Accuracy& one, const Accuracy& reference, double margin) {
  return one.azimuth_deg <= (1 + margin) * reference.azimuth_deg &&
         one.translation_percent <= (1 + margin) * reference.translation_percent &&
         one.within_15_deg >= (1 - margin) * reference.within_15_deg &&
         one.with_pose >= (1 - margin) * reference.with_pose;
}

}  // namespace armature
