// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/joint_refinement.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "association/matching.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

// Tuned on office_dev and redkitchen_a.
constexpr double kFirstBoxLossScale = 30;  // standard deviations: a side far off draws, at first
constexpr int kLeastMatchedEdges = 2;      // fewer say nothing
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

// An object of the graph as one camera sees it.
struct SeenObject {
  PoseAndShape at;
  Wireframe wireframe;
};

SeenObject SeenFrom(const Eigen::Isometry3d& T_world_camera, const GraphObject& object) {
  return {{T_world_camera.inverse() * object.T_world_object, object.coefficients},
          WireframeFromCoefficients(*object.model, object.coefficients)};
}

// The faces of every object of the map, whether it was detected in the image or not.
std::vector<std::vector<ImageFace>> MakeFaces(const MapGraph& graph, const std::vector<SeenObject>& seen,
                                              const Camera& camera) {
  std::vector<std::vector<ImageFace>> faces;
  for (size_t o = 0; o < seen.size(); ++o) {
    faces.push_back(
        ProjectFaces(camera, graph.objects[o].model->spec, seen[o].wireframe, seen[o].at.T_camera_object));
  }
  return faces;
}

// What hides one object: the faces of all others, and what its view has besides.
std::vector<ImageFace> Occluders(const std::vector<std::vector<ImageFace>>& faces, size_t object,
                                 const ObjectView& view) {
  std::vector<ImageFace> others = view.occluders;
  for (size_t o = 0; o < faces.size(); ++o) {
    if (o != object) others.insert(others.end(), faces[o].begin(), faces[o].end());
  }
  return others;
}

// Which sides of the box the object can be taken to end at, given where the map has it: those that the
// image's border does not cut and beyond which it does not go on.
BoxSides SidesSeen(const ObjectView& view, const SeenObject& object, const BoxOptions& options) {
  const Box& box = view.detection.box;
  BoxSides sides = SidesAtImageBorder(box, *view.camera);
  ProjectedWireframe projected;
  ProjectEdges(*view.camera, object.wireframe, object.at.T_camera_object, Box{-1e5, -1e5, 2e5, 2e5},
               projected);
  const std::array<ExtremePoint, 4> extremes = Extremes(projected);
  const auto [sigma_x, sigma_y] = SideSigmas(box, options);
  const std::array<double, 4> beyond = {box.left() - extremes[0].pixel, box.top() - extremes[1].pixel,
                                        extremes[2].pixel - box.right(), extremes[3].pixel - box.bottom()};
  for (size_t side = 0; side < 4; ++side) {
    if (extremes[side].edge >= 0 && beyond[side] > 2 * (side % 2 == 0 ? sigma_x : sigma_y))
      sides[side] = BoxSide::kOpen;
  }
  return sides;
}

std::optional<ObjectFactor> MakeFactor(const MapObservation& observation, const SeenObject& object,
                                       const std::vector<ImageFace>& occluders, const MatchGate& gate,
                                       const BoxOptions& box, const ResectionOptions& resection) {
  const ObjectView& view = observation.view;
  const BoxSides sides = SidesSeen(view, object, box);
  ProjectedWireframe projected;
  ProjectWireframe(*view.camera, view.model->spec, object.wireframe, object.at.T_camera_object,
                   ClipBox(view.detection.box, sides, *view.camera), occluders, projected);
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
  resection.box_loss_scale = Annealed(kFirstBoxLossScale, given.box_loss_scale, round, options);
  for (size_t i = 0; i < frames.size(); ++i) {
    if (frames[i].observations.empty()) continue;
    std::vector<SeenObject> seen;
    for (const GraphObject& object : graph.objects) seen.push_back(SeenFrom(graph.T_world_camera[i], object));
    const auto faces = MakeFaces(graph, seen, *frames[i].observations.front().view.camera);
    for (size_t j = 0; j < frames[i].observations.size(); ++j) {
      if (phi[i][j] < 0) continue;
      const auto object = static_cast<size_t>(phi[i][j]);
      const MapObservation& observation = frames[i].observations[j];
      std::optional<ObjectFactor> factor = MakeFactor(
          observation, seen[object], Occluders(faces, object, observation.view), gate, box, resection);
      if (!factor) continue;
      factor->camera = static_cast<int>(i);
      factor->object = phi[i][j];
      graph.observations.push_back(std::move(*factor));
    }
  }
}

}  // namespace armature
