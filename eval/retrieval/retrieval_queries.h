// SPDX-License-Identifier: BSD-3-Clause
// What retrieval is asked when it is evaluated: objects whose CAD model is known.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "eval/objects/object_matching.h"
#include "io/run_results.h"
#include "mapping/solve_map.h"
#include "retrieval/instance_library.h"
#include "retrieval/shape_distance.h"
#include "retrieval/sightings.h"
#include "truth/ground_truth.h"

namespace armature {

struct RetrievalQuery {
  std::string run{};                           // as shown; empty: of no run
  std::string sequence{};                      // its name; empty: of none
  std::string object{};                        // id in the map; empty: of no map
  std::string category{};                      // "chair"
  std::string true_model{};                    // the CAD model's id, "armature:chair-0210"
  Eigen::Vector3d true_size{0, 0, 0};          // of the true object's bounding box, metres
  ShapeQuery shape{};                          // as it was estimated
  std::optional<ObjectSightings> sightings{};  // none: it was seen in no image
};

// The objects of a run's map with the true ones that their observations are of. What is wrong with where an
// object stands is no matter of retrieval.
ObjectPairs PairsBySight(const Map& map, const RunResults& run, const GroundTruth& truth);

// The cameras whose views MakeMapQueries needs, rising.
std::vector<size_t> PickCameras(const Map& map, const ObjectPairs& pairs, int most_views);

// A query a pair whose true object names its CAD model. `views` has PickCameras; at most `most_views` of them
// an object. The sightings point to what the views point to.
std::vector<RetrievalQuery> MakeMapQueries(const Map& map, const ObjectPairs& pairs, const GroundTruth& truth,
                                           const ViewsOfCameras& views, int most_views);

// Instances of a library as queries, without any images: each `every`-th of the category (the first one
// first), its coefficients with normal noise of so many standard deviations on each.
std::vector<RetrievalQuery> MakeLibraryQueries(const CategoryInstances& instances, int every, double noise,
                                               std::uint64_t seed);

}  // namespace armature
