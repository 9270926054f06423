// SPDX-License-Identifier: BSD-3-Clause
#include "eval/objects/object_matching.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/errors.h"
#include "base/text.h"
#include "geometry/assignment.h"

namespace armature {
namespace {

Eigen::MatrixXd Distances(const std::vector<PlacedObject>& map, const std::vector<TrueObject>& truth,
                          double gate_m) {
  Eigen::MatrixXd distances(truth.size(), map.size());
  for (size_t i = 0; i < truth.size(); ++i) {
    for (size_t j = 0; j < map.size(); ++j) {
      const double distance =
          (truth[i].T_world_object.translation() - map[j].T_world_object.translation()).norm();
      const bool allowed = truth[i].category == map[j].category && distance <= gate_m;
      distances(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = allowed ? distance : kForbidden;
    }
  }
  return distances;
}

// counts(i, j): observations of map object j that are of the true object i.
Eigen::MatrixXi CountObservations(const std::vector<PlacedObject>& map, const RunResults& run,
                                  const GroundTruth& truth) {
  Eigen::MatrixXi counts = Eigen::MatrixXi::Zero(static_cast<Eigen::Index>(truth.objects.size()),
                                                 static_cast<Eigen::Index>(map.size()));
  std::map<std::string, size_t> positions;
  for (size_t j = 0; j < map.size(); ++j) positions[map[j].id] = j;
  for (const auto& [key, observation] : run.observations) {
    const auto found = positions.find(observation.object);
    if (found == positions.end() && !observation.object.empty()) {
      throw InputError(
          fmt::format("{}: an observation is of object {}, which the map has not; the files are of two "
                      "runs, run it again",
                      (run.folder / "observations.csv").string(), Quoted(observation.object)));
    }
    const TrueObject* object = truth.FindObject(observation.timestamp, observation.index);
    if (found == positions.end() || !object || object->category != map[found->second].category) continue;
    ++counts(object - truth.objects.data(), static_cast<Eigen::Index>(found->second));
  }
  return counts;
}

}  // namespace

ObjectPairs MatchByDistance(const std::vector<PlacedObject>& map, const std::vector<TrueObject>& truth,
                            double gate_m) {
  ObjectPairs pairs;
  const std::vector<int> columns = Assign(Distances(map, truth, gate_m));
  for (size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] >= 0) pairs.emplace_back(static_cast<size_t>(columns[i]), i);
  }
  return pairs;
}

ObjectPairs MatchByDetections(const std::vector<PlacedObject>& map, const RunResults& run,
                              const GroundTruth& truth) {
  ObjectPairs pairs;
  Eigen::MatrixXi counts = CountObservations(map, run, truth);
  for (Eigen::Index j = 0; j < counts.cols() && counts.rows() > 0; ++j) {
    Eigen::Index most = 0;
    counts.col(j).maxCoeff(&most);
    // What a map object also saw of other true objects is a mistake of its making, no second identity.
    for (Eigen::Index i = 0; i < counts.rows(); ++i) counts(i, j) = i == most ? counts(i, j) : 0;
  }
  for (Eigen::Index i = 0; i < counts.rows() && counts.cols() > 0; ++i) {
    Eigen::Index best = 0;
    if (counts.row(i).maxCoeff(&best) > 0)
      pairs.emplace_back(static_cast<size_t>(best), static_cast<size_t>(i));
  }
  return pairs;
}

}  // namespace armature
