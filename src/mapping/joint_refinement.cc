// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/joint_refinement.h"

#include <cmath>
#include <optional>
#include <utility>

#include "association/matching.h"
#include "geometry/rotation.h"
#include "mapping/seen_objects.h"

namespace armature {
namespace {

// Tuned on office_dev and redkitchen_a.
constexpr int kLeastMatchedEdges = 2;  // fewer say nothing
constexpr FactorNoise kRefinementNoise{.measurement_scale = 2.5,
                                       .depth_sigma = 0.005,
                                       .lateral_sigma = 0.005,
                                       .rotation_sigma_deg = 1,
                                       .shape_sigma = 0.2};

// From `first` in the first round to `last` in the last, geometrically.
double Annealed(double first, double last, int round, const RefinementOptions& options) {
  const double progress = options.rounds > 1 ? round / (options.rounds - 1.0) : 1.0;
  return first * std::pow(last / first, progress);
}

std::optional<ObjectFactor> MakeFactor(const MapObservation& observation, const SeenObject& object,
                                       const std::vector<ImageFace>& occluders, const MatchGate& gate,
                                       const BoxOptions& box, const ResectionOptions& resection) {
  const ObjectView& view = observation.view;
  const BoxSides sides = SidesSeen(object, view, occluders, box);
  const ProjectedWireframe projected = ProjectSeen(object, view, sides, occluders);
  const std::vector<EdgeMatch> matches = MatchSegments(projected, view.segments, gate).matches;
  if (MatchedEdges(matches) < kLeastMatchedEdges) return std::nullopt;
  const ImageEvidence evidence = EvidenceAt({view, sides, matches, projected, object.at, box, resection});
  return MakeObjectFactor(evidence, object.at, 0, kRefinementNoise);
}

}  // namespace

void Relinearise(const std::vector<MapFrame>& frames, const ObjectOfObservation& phi, int round,
                 const BoxOptions& box, const ResectionOptions& given, const RefinementOptions& options,
                 MapGraph& graph) {
  graph.observations.clear();
  const double pixels = Annealed(options.first_gate_pixels, options.last_gate_pixels, round, options);
  const MatchGate gate{pixels, kRefinementAngleDeg * kDegree};
  ResectionOptions resection = given;
  resection.segment_sigma *= pixels / options.last_gate_pixels;
  for (size_t i = 0; i < frames.size(); ++i) {
    if (frames[i].observations.empty()) continue;
    const SeenObjects seen = SeeObjects(graph, i, *frames[i].observations.front().view.camera);
    for (size_t j = 0; j < frames[i].observations.size(); ++j) {
      if (phi[i][j] < 0) continue;
      const auto object = static_cast<size_t>(phi[i][j]);
      const MapObservation& observation = frames[i].observations[j];
      std::optional<ObjectFactor> factor = MakeFactor(
          observation, seen.objects[object], Occluders(seen, object, observation.view), gate, box, resection);
      if (!factor) continue;
      factor->camera = static_cast<int>(i);
      factor->object = phi[i][j];
      graph.observations.push_back(std::move(*factor));
    }
  }
}

}  // namespace armature
