// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/joint_refinement.h"

#include <optional>
#include <utility>

#include "association/matching.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

// An object of the graph as one camera sees it.
struct SeenObject {
  PoseAndShape at;
  Wireframe wireframe;
};

SeenObject SeenFrom(const Eigen::Isometry3d& T_world_camera, const GraphObject& object) {
  return {{T_world_camera.inverse() * object.T_world_object, object.coefficients},
          WireframeFromCoefficients(*object.model, object.coefficients)};
}

// What the frame's objects hide of each other.
std::vector<ImageFace> FacesOfOthers(const std::vector<SeenObject>& objects, const MapFrame& frame, size_t j) {
  std::vector<ImageFace> faces;
  for (size_t other = 0; other < objects.size(); ++other) {
    if (other == j || objects[other].wireframe.edges() == 0) continue;
    const ObjectView& view = frame.observations[other].view;
    for (ImageFace& face : ProjectFaces(*view.camera, view.model->spec, objects[other].wireframe,
                                        objects[other].at.T_camera_object)) {
      faces.push_back(std::move(face));
    }
  }
  return faces;
}

std::optional<ObjectFactor> FactorOf(const MapObservation& observation, const SeenObject& object,
                                     const std::vector<ImageFace>& occluders, const MatchGate& gate,
                                     const BoxOptions& box, const ResectionOptions& resection,
                                     const RefinementOptions& options) {
  const ObjectView& view = observation.view;
  ProjectedWireframe projected;
  ProjectWireframe(*view.camera, view.model->spec, object.wireframe, object.at.T_camera_object,
                   ClipBox(view.detection.box, observation.sides, *view.camera), occluders, projected);
  const std::vector<EdgeMatch> matches = MatchSegments(projected, view.segments, gate).matches;
  if (MatchedEdges(matches) < options.min_edges) return std::nullopt;
  const ImageEvidence evidence =
      EvidenceAt(view, observation.sides, matches, projected, object.at, box, resection);
  return MakeObjectFactor(evidence, object.at, 0, options.noise);
}

}  // namespace

void Relinearise(const std::vector<MapFrame>& frames, const ObjectOfObservation& phi, double gate_pixels,
                 const BoxOptions& box, const ResectionOptions& resection, const RefinementOptions& options,
                 MapGraph& graph) {
  graph.observations.clear();
  const MatchGate gate{gate_pixels, options.gate_angle_deg * kDegree};
  for (size_t i = 0; i < frames.size(); ++i) {
    std::vector<SeenObject> objects(frames[i].observations.size());
    for (size_t j = 0; j < objects.size(); ++j) {
      if (phi[i][j] < 0) continue;
      objects[j] = SeenFrom(graph.T_world_camera[i], graph.objects[static_cast<size_t>(phi[i][j])]);
    }
    for (size_t j = 0; j < objects.size(); ++j) {
      if (phi[i][j] < 0) continue;
      const std::vector<ImageFace> occluders = FacesOfOthers(objects, frames[i], j);
      std::optional<ObjectFactor> factor =
          FactorOf(frames[i].observations[j], objects[j], occluders, gate, box, resection, options);
      if (!factor) continue;
      factor->camera = static_cast<int>(i);
      factor->object = phi[i][j];
      graph.observations.push_back(std::move(*factor));
    }
  }
}

}  // namespace armature
