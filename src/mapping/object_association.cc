// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/object_association.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "association/box_constraints.h"
#include "geometry/assignment.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"
#include "mapping/map_objects.h"
#include "mapping/object_factors.h"

namespace armature {
namespace {

// Intersections over union: two things cannot be in one place, so objects whose boxes overlap more are one;
// and what a detection's box and an object's projection have to have in common.
constexpr double kSamePlace = 0.3, kSeenOverlap = 0.3;
constexpr int kTogether = 2;          // frames that may show both of two objects that are one
constexpr size_t kAskedFactors = 25;  // of an object, when another is compared with it
constexpr size_t kRivals = 5;         // merges of which only one can be, handed back at most

struct MergeCandidate {
  Merge merge;
  double score = 0;  // squared Mahalanobis distance per row
};

// The factors and frames of each object.
struct Seen {
  std::vector<const ObjectFactor*> factors;
  std::set<int> cameras;
};

std::vector<Seen> CollectSeen(const MapGraph& graph) {
  std::vector<Seen> seen(graph.objects.size());
  for (const ObjectFactor& factor : graph.observations) {
    seen[static_cast<size_t>(factor.object)].factors.push_back(&factor);
    seen[static_cast<size_t>(factor.object)].cameras.insert(factor.camera);
  }
  return seen;
}

int Together(const Seen& a, const Seen& b) {
  int count = 0;
  for (const int camera : a.cameras) count += b.cameras.count(camera) ? 1 : 0;
  return count;
}

// Travelled length in metres at each camera; turning counts as well, a metre for a radian.
std::vector<double> Travelled(const MapGraph& graph) {
  std::vector<double> travelled(1, 0.0);
  for (size_t i = 1; i < graph.T_world_camera.size(); ++i) {
    const Eigen::Isometry3d step = graph.T_world_camera[i - 1].inverse() * graph.T_world_camera[i];
    travelled.push_back(travelled.back() + step.translation().norm() +
                        Eigen::AngleAxisd(step.linear()).angle());
  }
  return travelled;
}

// The least difference along an axis (travelled metres, seconds) between a view of the one and a view of the
// other. `axis`: a value a camera, growing.
double LeastBetween(const Seen& a, const Seen& b, const std::vector<double>& axis) {
  double least = 1e18;
  const auto at = [&](int camera) { return axis[static_cast<size_t>(camera)]; };
  for (const int camera : b.cameras) {
    const auto next = a.cameras.lower_bound(camera);
    if (next != a.cameras.end()) least = std::min(least, at(*next) - at(camera));
    if (next != a.cameras.begin()) least = std::min(least, at(camera) - at(*std::prev(next)));
  }
  return least;
}

std::vector<double> CollectStamps(const std::vector<MapFrame>& frames) {
  std::vector<double> stamps;
  for (const MapFrame& frame : frames) stamps.push_back(frame.timestamp);
  return stamps;
}

// How far the odometry drifts from one object to the other at best: by way of others that tie early frames to
// late ones, a loop that has been closed shortens the way (Floyd and Warshall).
Eigen::MatrixXd WaysBetween(const std::vector<Seen>& seen, const std::vector<double>& travelled) {
  const auto n = static_cast<Eigen::Index>(seen.size());
  Eigen::MatrixXd way(n, n);
  for (Eigen::Index a = 0; a < n; ++a) {
    for (Eigen::Index b = 0; b < n; ++b) {
      way(a, b) =
          a == b ? 0 : LeastBetween(seen[static_cast<size_t>(a)], seen[static_cast<size_t>(b)], travelled);
    }
  }
  for (Eigen::Index via = 0; via < n; ++via) {
    for (Eigen::Index a = 0; a < n; ++a) {
      for (Eigen::Index b = 0; b < n; ++b) way(a, b) = std::min(way(a, b), way(a, via) + way(via, b));
    }
  }
  return way;
}

// The median, over the views of b, of the squared Mahalanobis distance per row at which they see a.
double Distance(const MapGraph& graph, const GraphObject& a, const Seen& b, double turn, bool flipped,
                const DriftNoise& drift) {
  std::vector<double> distances;
  const size_t step = 1 + b.factors.size() / kAskedFactors;
  for (size_t k = 0; k < b.factors.size(); k += step) {
    ObjectFactor factor = *b.factors[k];
    if (turn != 0) Turn(turn, factor);
    if (flipped) MarginalizeRotation(factor);
    const Eigen::Isometry3d T_camera_a =
        graph.T_world_camera[static_cast<size_t>(factor.camera)].inverse() * a.T_world_object;
    const Eigen::VectorXd residual = Residual(WithDrift(factor, drift), {T_camera_a, a.coefficients});
    distances.push_back(residual.squaredNorm() / static_cast<double>(residual.size()));
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

// How well the views of `joined` agree that it is `kept`; `way`: metres between them.
MergeCandidate Compare(const MapGraph& graph, size_t kept, size_t joined, const Seen& seen, double way,
                       const ObjectAssociationOptions& options) {
  const GraphObject &a = graph.objects[kept], &b = graph.objects[joined];
  const double yaw = YawBetween(a.T_world_object, b.T_world_object);
  const double turned = AzimuthDifference(yaw, 0, a.model->spec.symmetry_order);
  const Merge merge{static_cast<int>(kept), static_cast<int>(joined), turned - yaw,
                    std::abs(turned) > 0.5 * M_PI};
  const DriftNoise drift{options.drift * way, options.turn_drift_deg * kDegree * way};
  const double distance = Distance(graph, a, seen, merge.turn, merge.flipped, drift);
  const bool overlap = IntersectionOverUnion(MakeBox(a), MakeBox(b)) > kSamePlace;
  return {merge, overlap ? std::min(distance, options.gate) : distance};
}

// All pairs of objects that may be one, the best first; those whose fronts disagree last.
std::vector<MergeCandidate> FindCandidates(const MapGraph& graph, const std::vector<MapFrame>& frames,
                                           std::optional<double> seconds_between,
                                           const ObjectAssociationOptions& options) {
  const std::vector<Seen> seen = CollectSeen(graph);
  const Eigen::MatrixXd ways = WaysBetween(seen, Travelled(graph));
  const std::vector<double> stamps = CollectStamps(frames);
  std::vector<MergeCandidate> candidates;
  for (size_t a = 0; a < seen.size(); ++a) {
    for (size_t b = 0; b < seen.size(); ++b) {
      const bool more = seen[a].factors.size() > seen[b].factors.size() ||
                        (seen[a].factors.size() == seen[b].factors.size() && a < b);
      if (a == b || graph.objects[a].model != graph.objects[b].model || !more) continue;
      if (Together(seen[a], seen[b]) > kTogether) continue;
      if (seconds_between && LeastBetween(seen[a], seen[b], stamps) > *seconds_between) continue;
      const double way = ways(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
      const MergeCandidate candidate = Compare(graph, a, b, seen[b], way, options);
      if (candidate.score <= options.gate) candidates.push_back(candidate);
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const MergeCandidate& a, const MergeCandidate& b) {
                     return std::pair(a.merge.flipped, a.score) < std::pair(b.merge.flipped, b.score);
                   });
  return candidates;
}

// The objects of two merges that have exactly one object in common: the two that are not common to them.
std::optional<std::pair<int, int>> Others(const Merge& a, const Merge& b) {
  if (a.kept == b.kept && a.joined != b.joined) return std::pair(a.joined, b.joined);
  if (a.joined == b.joined && a.kept != b.kept) return std::pair(a.kept, b.kept);
  if (a.kept == b.joined && a.joined != b.kept) return std::pair(a.joined, b.kept);
  if (a.joined == b.kept && a.kept != b.joined) return std::pair(a.kept, b.joined);
  return std::nullopt;
}

// Itself first, then the merges that cannot be if it is: those that take one of its objects for a third one
// which cannot be the same as its other. What would have to be flipped is no rival of what need not.
std::vector<Merge> FindRivals(const MergeCandidate& candidate,
                              const std::vector<MergeCandidate>& candidates) {
  std::vector<Merge> rivals{candidate.merge};
  for (const MergeCandidate& rival : candidates) {
    const auto others = Others(candidate.merge, rival.merge);
    if (!others || (rival.merge.flipped && !candidate.merge.flipped)) continue;
    const bool may_be_one = std::any_of(candidates.begin(), candidates.end(), [&](const MergeCandidate& c) {
      return std::minmax(c.merge.kept, c.merge.joined) == std::minmax(others->first, others->second);
    });
    if (!may_be_one) rivals.push_back(rival.merge);
  }
  return rivals;
}

}  // namespace

OrientedBox MakeBox(const GraphObject& object) {
  return {object.T_world_object, std::exp(object.log_size) * BoundingBoxSize(WireframeFromCoefficients(
                                                                 *object.model, object.coefficients))};
}

std::vector<Merge> FindMerges(const MapGraph& graph, const std::vector<MapFrame>& frames,
                              std::optional<double> seconds_between,
                              const ObjectAssociationOptions& options) {
  const std::vector<MergeCandidate> candidates = FindCandidates(graph, frames, seconds_between, options);
  std::vector<Merge> first;
  for (const MergeCandidate& candidate : candidates) {
    std::vector<Merge> rivals = FindRivals(candidate, candidates);
    if (rivals.size() == 1) return rivals;
    if (first.empty()) first = std::move(rivals);
  }
  first.resize(std::min(first.size(), kRivals));
  return first;
}

void ApplyMerge(const Merge& merge, MapGraph& graph, ObjectOfObservation& phi) {
  const auto renumbered = [&](int object) {
    if (object == merge.joined) object = merge.kept;
    return object > merge.joined ? object - 1 : object;
  };
  for (ObjectFactor& factor : graph.observations) {
    if (factor.object == merge.joined) {
      if (merge.turn != 0) Turn(merge.turn, factor);
      if (merge.flipped) MarginalizeRotation(factor);
    }
    factor.object = renumbered(factor.object);
  }
  for (std::vector<int>& of_frame : phi) {
    for (int& object : of_frame) object = renumbered(object);
  }
  graph.objects.erase(graph.objects.begin() + merge.joined);
}

void DropUnseen(MapGraph& graph, ObjectOfObservation& phi) {
  std::vector<int> renumbered(graph.objects.size(), -1);
  for (const ObjectFactor& factor : graph.observations) renumbered[static_cast<size_t>(factor.object)] = 0;
  std::vector<GraphObject> seen;
  for (size_t o = 0; o < renumbered.size(); ++o) {
    if (renumbered[o] < 0) continue;
    renumbered[o] = static_cast<int>(seen.size());
    seen.push_back(std::move(graph.objects[o]));
  }
  graph.objects = std::move(seen);
  for (ObjectFactor& factor : graph.observations)
    factor.object = renumbered[static_cast<size_t>(factor.object)];
  for (std::vector<int>& of_frame : phi) {
    for (int& object : of_frame) object = object < 0 ? -1 : renumbered[static_cast<size_t>(object)];
  }
}

std::vector<TimeSpan> SeenSpans(size_t objects, const std::vector<MapFrame>& frames,
                                const ObjectOfObservation& phi) {
  std::vector<TimeSpan> spans(objects);
  for (size_t i = 0; i < frames.size(); ++i) {
    for (const int object : phi[i]) {
      if (object < 0) continue;
      TimeSpan& span = spans[static_cast<size_t>(object)];
      span.first = std::min(span.first, frames[i].timestamp);
      span.last = std::max(span.last, frames[i].timestamp);
    }
  }
  return spans;
}

std::vector<int> AssociateFrame(const std::vector<GraphObject>& objects, const std::vector<TimeSpan>& spans,
                                const PassedFrame& frame, const Eigen::Isometry3d& T_world_camera,
                                std::optional<double> seconds_between) {
  Eigen::MatrixXd costs = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(frame.boxes.size()),
                                                    static_cast<Eigen::Index>(objects.size()), kForbidden);
  for (size_t o = 0; o < objects.size() && !frame.boxes.empty(); ++o) {
    if (seconds_between && (frame.timestamp < spans[o].first - *seconds_between ||
                            frame.timestamp > spans[o].last + *seconds_between))
      continue;
    const PoseAndShape object{
        SeenAtUnitSize(T_world_camera.inverse() * objects[o].T_world_object, objects[o].log_size),
        objects[o].coefficients};
    if (object.T_camera_object.translation().z() < 0.1) continue;
    const auto expected = ExpectedBox(*frame.camera, *objects[o].model, object);
    if (!expected) continue;
    for (size_t j = 0; j < frame.boxes.size(); ++j) {
      if (frame.boxes[j].model != objects[o].model) continue;
      const auto agreement = BoxAgreement(*expected, frame.boxes[j].box, kSeenOverlap);
      if (!agreement) continue;
      costs(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(o)) = 1.3 - *agreement;
    }
  }
  return Assign(costs);
}

}  // namespace armature
