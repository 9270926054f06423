// SPDX-License-Identifier: BSD-3-Clause
// The images in which an object of a map was seen, for re-ranking.
#pragma once

#include <map>
#include <vector>

#include "mapping/solve_map.h"
#include "retrieval/instance_fit.h"

namespace armature {

struct Sighting {
  size_t camera = 0;     // of the map
  size_t detection = 0;  // of that image
};

// At most `most` of those in which phi has the object, spread evenly over them.
std::vector<Sighting> SightingsToLookAt(const Map& map, size_t object, int most);

// The views of a camera's detections, in their order; by camera.
using ViewsOfCameras = std::map<size_t, std::vector<ObjectView>>;

// `views` has all cameras of the sightings. The map's other objects hide this one.
ObjectSightings LookAt(const Map& map, size_t object, const std::vector<Sighting>& sightings,
                       const ViewsOfCameras& views, const Eigen::Vector3d& up_world);

// The mean of the objects' y axes, unit: what the map holds to be up; without objects that of a level camera.
Eigen::Vector3d EstimateUp(const Map& map);

}  // namespace armature
