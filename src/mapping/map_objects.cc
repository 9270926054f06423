// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/map_objects.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

constexpr double kKnotSeconds = 2;             // between the knots of the odometry's scale
constexpr double kLeastUpSigma = 1 * kDegree;  // up as the front end has it is never surer
// Where the odometry jumped, the camera went on as before but for about so much, radians and metres.
constexpr double kJumpTurn = 10 * kDegree, kJumpWay = 0.3;
constexpr double kFlipped = 50 * kDegree;  // views turned by more than this do not see the same front

struct PlacedView {
  int camera = 0;
  const MapObservation* observation = nullptr;
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();
};

// Views that agree within 0.2 m and 15 degrees are alike; beyond twice that it is all the same.
double Unlikeness(const PlacedView& a, const PlacedView& b, int symmetry_order) {
  const double apart = (a.T_world_object.translation() - b.T_world_object.translation()).norm() / 0.2;
  const double yaw = YawBetween(a.T_world_object, b.T_world_object);
  const double turned = AzimuthDifference(yaw, 0, symmetry_order) / (15 * kDegree);
  return std::min(apart * apart, 4.0) + std::min(turned * turned, 4.0);
}

// The view that most others agree with; of many views, about a hundred are asked.
const PlacedView& Medoid(const std::vector<PlacedView>& views) {
  const int symmetry_order = views.front().observation->view.model->spec.symmetry_order;
  const size_t step = 1 + views.size() / 100;
  size_t medoid = 0;
  double least = 1e18;
  for (size_t a = 0; a < views.size(); a += step) {
    double sum = 0;
    for (size_t b = 0; b < views.size(); b += step) sum += Unlikeness(views[a], views[b], symmetry_order);
    if (sum < least) {
      least = sum;
      medoid = a;
    }
  }
  return views[medoid];
}

ObjectFactor MakeViewFactor(const PlacedView& view, const GraphObject& object) {
  const double yaw = YawBetween(object.T_world_object, view.T_world_object);
  const double turned = AzimuthDifference(yaw, 0, object.model->spec.symmetry_order);
  ObjectFactor factor =
      MakeObjectFactor(view.observation->evidence, view.observation->measured, turned - yaw, FactorNoise{});
  if (std::abs(turned) > kFlipped) MarginalizeRotation(factor);
  factor.camera = view.camera;
  return factor;
}

// A longer gap between images counts as one of this length: knots are as many as images ask for, not as
// seconds pass between two sessions.
constexpr double kLongestGap = 60;  // seconds

// Together they weigh as one: what is wrong with a mounting is so in every frame.
void AddHeights(const std::vector<MapFrame>& frames, MapGraph& graph) {
  for (size_t i = 0; i < frames.size(); ++i) {
    if (!frames[i].camera_height) continue;
    const auto& [height, sigma] = *frames[i].camera_height;
    graph.heights.push_back(
        {static_cast<int>(i), height, sigma * std::sqrt(static_cast<double>(frames.size()))});
  }
}

double BeyondLongestGap(const MapFrame& earlier, const MapFrame& later) {
  return std::max(0.0, later.timestamp - earlier.timestamp - kLongestGap);
}

}  // namespace

double YawBetween(const Eigen::Isometry3d& T_world_a, const Eigen::Isometry3d& T_world_b) {
  const Eigen::Matrix3d R_a_b = T_world_a.linear().transpose() * T_world_b.linear();
  return std::atan2(R_a_b(0, 2), R_a_b(2, 2));
}

MapGraph MakeOdometryGraph(const std::vector<MapFrame>& frames, const ScaleEstimate& expected_scale,
                           const StepNoise& noise) {
  MapGraph graph;
  graph.expected_scale = expected_scale;
  graph.scale_is_held = expected_scale.sigma <= 0;
  const double scale = expected_scale.scale;
  const double start = frames.front().timestamp;
  double seconds = frames.back().timestamp - start;
  for (size_t i = 1; i < frames.size(); ++i) seconds -= BeyondLongestGap(frames[i - 1], frames[i]);
  const int knots = 2 + static_cast<int>(seconds / kKnotSeconds);
  double left_out = 0;
  graph.log_scale.assign(static_cast<size_t>(knots), std::log(scale));
  for (size_t i = 0; i < frames.size(); ++i) {
    Eigen::Isometry3d pose = frames[i].T_odom_camera;
    pose.translation() *= scale;
    graph.T_world_camera.push_back(pose);
    if (i == 0) continue;
    OdometryFactor step;
    step.from = static_cast<int>(i) - 1;
    step.to = static_cast<int>(i);
    step.T_from_to = frames[i - 1].T_odom_camera.inverse() * frames[i].T_odom_camera;
    // Of passed frames between them as of one step: errors of an odometry's small steps are not independent,
    // and a camera that a long video leaves free follows the views' errors: the scale shrinks.
    step.rotation_sigma = noise.rotation_sigma_deg * kDegree;
    step.translation_sigma =
        noise.translation_sigma * scale * step.T_from_to.translation().norm() + noise.translation_floor;
    if (frames[i].follows_jump) {
      step.rotation_sigma = kJumpTurn;
      step.translation_sigma = kJumpWay;
    }
    const double gap = BeyondLongestGap(frames[i - 1], frames[i]);
    const double at =
        (0.5 * (frames[i].timestamp + frames[i - 1].timestamp) - start - left_out - 0.5 * gap) / kKnotSeconds;
    left_out += gap;
    step.knot = std::clamp(static_cast<int>(at), 0, knots - 2);
    step.share = at - step.knot;
    graph.odometry.push_back(step);
  }
  AddHeights(frames, graph);
  const MapFrame& last = frames.back();  // what it knows of up, all frames before have told
  graph.up_world = last.T_odom_camera.linear() * last.up_camera;
  graph.up_sigma = std::max(last.up_sigma, kLeastUpSigma);
  return graph;
}

ObjectOfObservation BreakTracks(const std::vector<MapFrame>& frames, double recent_seconds,
                                int min_observations) {
  struct Piece {
    double last_seen = 0;
    int observations = 0;                            // those of passed frames as well
    std::vector<std::pair<size_t, size_t>> members;  // frame, observation
  };
  std::vector<Piece> pieces;
  std::map<int, size_t> piece_of_track;
  const auto see = [&](int track, bool is_joined, double timestamp) -> Piece& {
    const auto found = piece_of_track.find(track);
    if (found == piece_of_track.end() ||
        (!is_joined && timestamp - pieces[found->second].last_seen > recent_seconds)) {
      piece_of_track[track] = pieces.size();
      pieces.emplace_back();
    }
    Piece& piece = pieces[piece_of_track[track]];
    piece.last_seen = timestamp;
    ++piece.observations;
    return piece;
  };
  ObjectOfObservation phi;
  for (size_t i = 0; i < frames.size(); ++i) {
    for (const PassedFrame& passed : frames[i].passed) {
      for (const SeenBox& box : passed.boxes) {
        if (box.track >= 0) see(box.track, false, passed.timestamp);
      }
    }
    phi.emplace_back(frames[i].observations.size(), -1);
    for (size_t j = 0; j < frames[i].observations.size(); ++j) {
      const auto& [view, track, is_joined, measured, evidence] = frames[i].observations[j];
      if (track >= 0) see(track, is_joined, frames[i].timestamp).members.emplace_back(i, j);
    }
  }
  int objects = 0;
  for (const Piece& piece : pieces) {
    if (piece.observations < min_observations || piece.members.empty()) continue;
    for (const auto& [i, j] : piece.members) phi[i][j] = objects;
    ++objects;
  }
  return phi;
}

void AddObjects(const std::vector<MapFrame>& frames, const ObjectOfObservation& phi, MapGraph& graph) {
  std::map<int, std::vector<PlacedView>> views;
  for (size_t i = 0; i < frames.size(); ++i) {
    for (size_t j = 0; j < frames[i].observations.size(); ++j) {
      const MapObservation& observation = frames[i].observations[j];
      if (phi[i][j] < 0) continue;
      views[phi[i][j]].push_back({static_cast<int>(i), &observation,
                                  graph.T_world_camera[i] * observation.measured.T_camera_object});
    }
  }
  for (const auto& [number, of_object] : views) {
    const PlacedView& medoid = Medoid(of_object);
    graph.objects.push_back(
        {medoid.observation->view.model, medoid.T_world_object, medoid.observation->measured.coefficients});
  }
  AddViewFactors(frames, phi, graph);
}

void AddViewFactors(const std::vector<MapFrame>& frames, const ObjectOfObservation& phi, MapGraph& graph) {
  for (size_t i = 0; i < frames.size(); ++i) {
    for (size_t j = 0; j < frames[i].observations.size(); ++j) {
      if (phi[i][j] < 0) continue;
      const MapObservation& observation = frames[i].observations[j];
      const PlacedView view{static_cast<int>(i), &observation,
                            graph.T_world_camera[i] * observation.measured.T_camera_object};
      graph.observations.push_back(MakeViewFactor(view, graph.objects[static_cast<size_t>(phi[i][j])]));
      graph.observations.back().object = phi[i][j];
    }
  }
}

}  // namespace armature
