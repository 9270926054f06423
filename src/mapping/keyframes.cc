// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/keyframes.h"

#include <algorithm>
#include <utility>

#include "geometry/rotation.h"
#include "geometry/se3.h"
#include "mapping/object_association.h"

namespace armature {
namespace {

constexpr size_t kFramesOfPlace = 5;
// A place: cameras this near to each other, metres and radians: the same edges, the same wrong matches.
constexpr double kPlaceRadius = 0.3, kPlaceTurn = 10 * kDegree;

bool IsSamePlace(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  if ((a.translation() - b.translation()).squaredNorm() > kPlaceRadius * kPlaceRadius) return false;
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle() < kPlaceTurn;
}

bool ShowTheSame(const MapFrame& a, const MapFrame& b) {
  const auto is_same_model = [](const MapObservation& x, const MapObservation& y) {
    return x.view.model == y.view.model;
  };
  return std::is_permutation(a.observations.begin(), a.observations.end(), b.observations.begin(),
                             b.observations.end(), is_same_model);
}

// From the kept camera before on as the odometry goes; what then is missing to the kept camera after it comes
// in proportion to time.
Eigen::Isometry3d PlaceBetween(const MapFrame& before, const MapFrame& after,
                               const Eigen::Isometry3d& T_world_before,
                               const Eigen::Isometry3d& T_world_after, double scale,
                               const PassedFrame& passed) {
  const auto follow = [&](const Eigen::Isometry3d& T_odom_camera) {
    Eigen::Isometry3d T_before_camera = before.T_odom_camera.inverse() * T_odom_camera;
    T_before_camera.translation() *= scale;
    return T_world_before * T_before_camera;
  };
  const Vector6d missing = LogSE3(follow(after.T_odom_camera).inverse() * T_world_after);
  const double share = (passed.timestamp - before.timestamp) / (after.timestamp - before.timestamp);
  return follow(passed.T_odom_camera) * ExpSE3(share * missing);
}

}  // namespace

std::optional<size_t> FindSuperfluousFrame(const std::vector<MapFrame>& frames,
                                           const std::vector<Eigen::Isometry3d>& T_world_camera) {
  if (frames.size() <= kAlwaysKept) return std::nullopt;
  const size_t last = frames.size() - 1;
  size_t of_place = 1;
  std::optional<size_t> superfluous;
  double least_gap = 0;
  for (size_t i = 1; i < last; ++i) {
    if (!IsSamePlace(T_world_camera[i], T_world_camera[last])) continue;
    if (!ShowTheSame(frames[i], frames[last])) continue;
    ++of_place;
    if (frames[i].follows_jump || frames[i + 1].follows_jump) continue;
    const double gap = frames[i + 1].timestamp - frames[i - 1].timestamp;
    if (superfluous && gap >= least_gap) continue;
    superfluous = i;
    least_gap = gap;
  }
  return of_place > kFramesOfPlace ? superfluous : std::nullopt;
}

void PassOver(size_t index, std::vector<MapFrame>& frames) {
  std::vector<PassedFrame> passed = std::move(frames[index].passed);
  passed.push_back(WithoutEvidence(frames[index]));
  std::vector<PassedFrame>& later = frames[index + 1].passed;
  later.insert(later.begin(), std::make_move_iterator(passed.begin()), std::make_move_iterator(passed.end()));
  frames.erase(frames.begin() + static_cast<std::ptrdiff_t>(index));
}

Map WithPassedFrames(const std::vector<MapFrame>& frames, const Map& map,
                     std::optional<double> seconds_between) {
  std::vector<GraphObject> objects;
  for (const MapObject& object : map.objects)
    objects.push_back({object.model, object.T_world_object, object.coefficients, object.log_size});
  const std::vector<TimeSpan> spans = SeenSpans(objects.size(), frames, map.phi);
  Map whole = map;
  whole.timestamps.clear();
  whole.T_world_camera.clear();
  whole.phi.clear();
  const auto add = [&](double timestamp, const Eigen::Isometry3d& T_world_camera, std::vector<int> phi) {
    whole.timestamps.push_back(timestamp);
    whole.T_world_camera.push_back(T_world_camera);
    whole.phi.push_back(std::move(phi));
  };
  for (size_t i = 0; i < frames.size(); ++i) {
    for (const PassedFrame& passed : frames[i].passed) {  // none before the first
      const Eigen::Isometry3d T_world_camera =
          PlaceBetween(frames[i - 1], frames[i], map.T_world_camera[i - 1], map.T_world_camera[i],
                       map.MeanScale(), passed);
      std::vector<int> phi = AssociateFrame(objects, spans, passed, T_world_camera, seconds_between);
      for (const int object : phi) {
        if (object >= 0) ++whole.objects[static_cast<size_t>(object)].observations;
      }
      add(passed.timestamp, T_world_camera, std::move(phi));
    }
    add(map.timestamps[i], map.T_world_camera[i], map.phi[i]);
  }
  return whole;
}

}  // namespace armature
