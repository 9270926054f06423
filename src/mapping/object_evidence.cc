// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/object_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "association/matching.h"
#include "base/statistics.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"
#include "mapping/seen_objects.h"

namespace armature {
namespace {

constexpr MatchGate kEvidenceGate{4, 6 * kDegree};
constexpr std::array kBeside{-0.35, -0.2, 0.2, 0.35};  // metres to the right

// A frame should show an object that is neither too small nor too far nor hidden, cut or behind.
constexpr double kLeastShown = 40;                // pixels
constexpr double kShownFrom = 0.4, kShownTo = 5;  // metres
constexpr double kShownShare = 0.45;              // of the length of its edges; its own faces hide a third

constexpr double kNoBoxError = 0.3;  // where all sides are cut or hidden

bool ShouldBeShown(const Camera& camera, const CategorySpec& spec, const SeenObject& object,
                   const std::vector<ImageFace>& occluders) {
  const double depth = object.at.T_camera_object.translation().z() * object.size;
  if (depth < kShownFrom || depth > kShownTo) return false;
  const ProjectedWireframe whole = ProjectWhole(object, camera);
  ProjectedWireframe shown;
  ProjectWireframe(camera, spec, object.wireframe, object.at.T_camera_object,
                   Box{0, 0, camera.width - 1.0, camera.height - 1.0}, occluders, shown);
  double length = 0;
  for (const ProjectedEdge& edge : whole.edges) length += edge.length;
  const auto around = BoxAround(shown);
  return around && std::max(around->width, around->height) > kLeastShown &&
         shown.VisibleLength() > kShownShare * length;
}

// Sums over the views of one object.
struct Tally {
  int views = 0, expected = 0, detected = 0;
  double visible = 0, covered = 0, visible_beside = 0, covered_beside = 0;  // pixels
  std::vector<double> box_errors, turn_errors;
  std::vector<Eigen::Vector3d> rays;  // from the object to the cameras, unit
};

void AddBoxErrors(const ObjectView& view, const BoxSides& sides, const ProjectedWireframe& projected,
                  Tally& tally) {
  const Box& box = view.detection.box;
  const std::array<double, 4> at{box.left(), box.top(), box.right(), box.bottom()};
  const std::array<ExtremePoint, 4> extremes = Extremes(projected);
  for (size_t side = 0; side < 4; ++side) {
    if (sides[side] == BoxSide::kOpen || extremes[side].edge < 0) continue;
    const double size = side % 2 == 0 ? box.width : box.height;
    tally.box_errors.push_back(std::abs(extremes[side].pixel - at[side]) / size);
  }
}

void AddView(const ObjectView& view, const SeenObject& object, const std::vector<ImageFace>& occluders,
             const BoxOptions& box, Tally& tally) {
  ++tally.views;
  const BoxSides sides = SidesSeen(object, view, occluders, box);
  const ProjectedWireframe projected = ProjectSeen(object, view, sides, occluders);
  tally.visible += projected.VisibleLength();
  tally.covered += CoveredLength(projected, view.segments, kEvidenceGate);
  AddBoxErrors(view, sides, projected, tally);
  if (view.detection.azimuth) {
    const Eigen::Isometry3d& T = object.at.T_camera_object;
    const double azimuth = ViewpointFromRotation(T.linear(), T.translation()).azimuth;
    tally.turn_errors.push_back(
        std::abs(AzimuthDifference(azimuth, *view.detection.azimuth, view.model->spec.symmetry_order)));
  }
  for (const double shift : kBeside) {
    SeenObject beside = object;
    beside.at.T_camera_object.translation().x() += shift;
    const ProjectedWireframe there = ProjectSeen(beside, view, sides, occluders);
    tally.visible_beside += there.VisibleLength();
    tally.covered_beside += CoveredLength(there, view.segments, kEvidenceGate);
  }
}

void AddFrame(const MapFrame& frame, size_t camera, const std::vector<int>& object_of, const MapGraph& graph,
              const BoxOptions& box, std::vector<Tally>& tallies) {
  const Camera& intrinsics = *frame.observations.front().view.camera;
  const SeenObjects seen = SeeObjects(graph, camera, intrinsics);
  std::vector<const ObjectView*> view_of(tallies.size(), nullptr);
  for (size_t j = 0; j < object_of.size(); ++j) {
    if (object_of[j] >= 0) view_of[static_cast<size_t>(object_of[j])] = &frame.observations[j].view;
  }
  for (size_t o = 0; o < tallies.size(); ++o) {
    const std::vector<ImageFace> occluders = Occluders(seen, o, {});
    if (ShouldBeShown(intrinsics, graph.objects[o].model->spec, seen.objects[o], occluders)) {
      ++tallies[o].expected;
      if (view_of[o] != nullptr) ++tallies[o].detected;
    }
    if (view_of[o] == nullptr) continue;
    AddView(*view_of[o], seen.objects[o], occluders, box, tallies[o]);
    tallies[o].rays.push_back(
        (graph.T_world_camera[camera].translation() - graph.objects[o].T_world_object.translation())
            .normalized());
  }
}

double WidestAngle(const std::vector<Eigen::Vector3d>& rays) {
  double least_cosine = 1;
  for (const Eigen::Vector3d& a : rays) {
    for (const Eigen::Vector3d& b : rays) least_cosine = std::min(least_cosine, a.dot(b));
  }
  return std::acos(std::max(least_cosine, -1.0));
}

double Share(double part, double whole) { return whole > 0 ? part / whole : 0; }

}  // namespace

std::vector<ObjectEvidence> CollectEvidence(const std::vector<MapFrame>& frames,
                                            const ObjectOfObservation& phi, const MapGraph& graph,
                                            const BoxOptions& box) {
  std::vector<Tally> tallies(graph.objects.size());
  for (size_t i = 0; i < frames.size(); ++i) {
    if (!frames[i].observations.empty()) AddFrame(frames[i], i, phi[i], graph, box, tallies);
  }
  std::vector<ObjectEvidence> all;
  for (size_t o = 0; o < tallies.size(); ++o) {
    const Tally& tally = tallies[o];
    ObjectEvidence& evidence = all.emplace_back();
    evidence.views = tally.views;
    evidence.detected_share = (tally.detected + 1.0) / (tally.expected + 2.0);  // Laplace's rule
    evidence.coverage = Share(tally.covered, tally.visible);
    evidence.coverage_beside = Share(tally.covered_beside, tally.visible_beside);
    evidence.box_error = tally.box_errors.empty() ? kNoBoxError : Median(tally.box_errors);
    if (!tally.turn_errors.empty()) evidence.turn_error = Median(tally.turn_errors);
    evidence.log_size = graph.objects[o].log_size;
    evidence.parallax = WidestAngle(tally.rays);
  }
  return all;
}

double ComputeProbability(const ObjectEvidence& evidence) {
  const double share = evidence.detected_share;
  const double turn = evidence.turn_error ? -1.243 * std::min(*evidence.turn_error, 1.0) : -2.090;
  const double log_odds =
      -4.735 + 0.122 * std::log(std::max(evidence.views, 1)) + 0.475 * std::log(share / (1 - share)) +
      3.480 * evidence.coverage - 0.963 * evidence.coverage_beside -
      1.344 * std::log(std::max(evidence.box_error, 0.01)) + turn -
      4.740 * std::min(std::abs(evidence.log_size), 0.3) + 1.302 * std::min(evidence.parallax, 1.0);
  return 1 / (1 + std::exp(-log_odds));
}

}  // namespace armature
