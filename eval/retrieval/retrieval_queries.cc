// SPDX-License-Identifier: BSD-3-Clause
#include "eval/retrieval/retrieval_queries.h"

#include <set>

#include "geometry/random.h"
#include "io/placed_objects.h"

namespace armature {

ObjectPairs PairsBySight(const Map& map, const RunResults& run, const GroundTruth& truth) {
  std::vector<PlacedObject> placed;
  for (const MapObject& object : map.objects) {
    placed.emplace_back();
    placed.back().id = object.id;
    placed.back().category = object.model->spec.name;
  }
  return MatchByDetections(placed, run, truth);
}

std::vector<size_t> PickCameras(const Map& map, const ObjectPairs& pairs, int most_views) {
  std::set<size_t> cameras;
  for (const auto& [object, of_truth] : pairs) {
    for (const Sighting& sighting : SightingsToLookAt(map, object, most_views))
      cameras.insert(sighting.camera);
  }
  return {cameras.begin(), cameras.end()};
}

std::vector<RetrievalQuery> MakeMapQueries(const Map& map, const ObjectPairs& pairs, const GroundTruth& truth,
                                           const ViewsOfCameras& views, int most_views) {
  const Eigen::Vector3d up_world = EstimateUp(map);
  std::vector<RetrievalQuery> queries;
  for (const auto& [object, of_truth] : pairs) {
    const TrueObject& true_object = truth.objects[of_truth];
    if (true_object.instance.empty()) continue;
    const MapObject& found = map.objects[object];
    const std::vector<Sighting> sightings = SightingsToLookAt(map, object, most_views);
    queries.push_back({.object = found.id,
                       .category = true_object.category,
                       .true_model = true_object.instance,
                       .true_size = true_object.size,
                       .shape = {found.coefficients, found.Size(), found.evidence},
                       .sightings = LookAt(map, object, sightings, views, up_world)});
  }
  return queries;
}

std::vector<RetrievalQuery> MakeLibraryQueries(const CategoryInstances& instances, int every, double noise,
                                               std::uint64_t seed) {
  Random random(seed);
  std::vector<RetrievalQuery> queries;
  for (int i = 0; i < instances.size(); i += every) {
    const Eigen::Vector3d size = instances.sizes.col(i).cast<double>();
    ShapeQuery shape{instances.coefficients.col(i).cast<double>(), size, std::nullopt};
    for (double& coefficient : shape.coefficients) coefficient += noise * random.Normal(0, 1);
    queries.push_back({.category = instances.category,
                       .true_model = instances.ids[static_cast<size_t>(i)],
                       .true_size = size,
                       .shape = std::move(shape)});
  }
  return queries;
}

}  // namespace armature
