// SPDX-License-Identifier: BSD-3-Clause
#include "retrieval/sightings.h"

#include <algorithm>
#include <utility>

namespace armature {
namespace {

std::vector<ImageFace> OthersFaces(const Map& map, size_t object, const Eigen::Isometry3d& T_world_camera,
                                   const Camera& camera) {
  std::vector<ImageFace> faces;
  for (size_t o = 0; o < map.objects.size(); ++o) {
    if (o == object) continue;
    const MapObject& other = map.objects[o];
    for (ImageFace& face : ProjectFaces(camera, other.model->spec, other.MakeWireframe(),
                                        T_world_camera.inverse() * other.T_world_object)) {
      faces.push_back(std::move(face));
    }
  }
  return faces;
}

}  // namespace

std::vector<Sighting> SightingsToLookAt(const Map& map, size_t object, int most) {
  std::vector<Sighting> all;
  for (size_t camera = 0; camera < map.phi.size(); ++camera) {
    for (size_t detection = 0; detection < map.phi[camera].size(); ++detection) {
      if (map.phi[camera][detection] == static_cast<int>(object)) all.push_back({camera, detection});
    }
  }
  const auto wanted = static_cast<size_t>(std::max(most, 0));
  if (all.size() <= wanted) return all;
  std::vector<Sighting> spread;
  for (size_t i = 0; i < wanted; ++i) spread.push_back(all[(2 * i + 1) * all.size() / (2 * wanted)]);
  return spread;
}

ObjectSightings LookAt(const Map& map, size_t object, const std::vector<Sighting>& sightings,
                       const ViewsOfCameras& views, const Eigen::Vector3d& up_world) {
  ObjectSightings seen;
  seen.T_world_object = map.objects[object].T_world_object;
  seen.up_world = up_world;
  for (const auto& [camera, detection] : sightings) {
    const Eigen::Isometry3d& T_world_camera = map.T_world_camera[camera];
    MapFrame frame;
    frame.timestamp = map.timestamps[camera];
    frame.observations.resize(1);
    ObjectView& view = frame.observations.front().view;
    view = views.at(camera)[detection];
    view.occluders = OthersFaces(map, object, T_world_camera, *view.camera);
    seen.frames.push_back(std::move(frame));
    seen.T_world_camera.push_back(T_world_camera);
  }
  return seen;
}

Eigen::Vector3d EstimateUp(const Map& map) {
  Eigen::Vector3d sum(0, 0, 0);
  for (const MapObject& object : map.objects) sum += object.T_world_object.linear().col(1);
  if (sum.norm() == 0) return {0, -1, 0};
  return sum.normalized();
}

}  // namespace armature
