// SPDX-License-Identifier: BSD-3-Clause
#include "eval/statistics/result_distance.h"

#include <algorithm>
#include <cmath>

#include "base/microseconds.h"
#include "base/text.h"
#include "eval/trajectories/trajectory_metrics.h"
#include "truth/observation_metrics.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

// A run without odometry has a trajectory without poses.
std::vector<TimedPose> ReadCameraPath(const fs::path& run) {
  const fs::path file = run / "trajectory.txt";
  return ReadTextLines(file).empty() ? std::vector<TimedPose>{} : ReadTumTrajectory(file);
}

std::vector<PlacedObject> LoadObjects(const fs::path& run) {
  const fs::path file = run / "objects.csv";
  return fs::exists(file) ? ReadPlacedObjects(file) : std::vector<PlacedObject>{};
}

void AddDistance(ComparedValues& distances, const ValueKey& key, double distance) {
  distances.pairs.push_back({key, {key.series, 0, distance}});
}

std::vector<ComparedValues> ObjectDistances(const fs::path& run_a, const std::vector<PlacedObject>& map_b,
                                            const std::vector<CategorySpec>& specs, double gate_m) {
  GroundTruth a;
  for (const PlacedObject& object : LoadObjects(run_a))
    a.objects.push_back({object.id, object.category, object.instance, object.T_world_object, object.size});
  ComparedValues centres{"object centres [m]", 4, {}, 0, 0};
  ComparedValues azimuths{"object azimuths [deg]", 2, {}, 0, 0};
  for (const EvaluatedObject& object :
       EvaluateObjects(map_b, a, specs, MatchByDistance(map_b, a.objects, gate_m))) {
    if (!object.error) {
      ++(object.status == ObjectStatus::kSpurious ? centres.only_b : centres.only_a);
      continue;
    }
    AddDistance(centres, {object.true_id}, object.error->centre_m);
    AddDistance(azimuths, {object.true_id}, std::abs(object.error->orientation.azimuth_deg));
  }
  azimuths.only_a = centres.only_a;
  azimuths.only_b = centres.only_b;
  return {centres, azimuths};
}

std::vector<Cell> DistanceRow(const ComparedValues& distances) {
  std::vector<double> values;
  for (const auto& [key, pair] : distances.pairs) values.push_back(pair.b);
  std::vector<Cell> row{TextCell(distances.name)};
  if (const auto statistics = SummarizeErrors(values)) {
    for (const double value : {statistics->median, statistics->mean, statistics->max})
      row.push_back(NumberCell(value, distances.digits));
  } else {
    row.insert(row.end(), 3, NoCell());
  }
  for (const size_t count : {distances.pairs.size(), distances.only_a, distances.only_b})
    row.push_back(CountCell(static_cast<long>(count)));
  return row;
}

}  // namespace

std::vector<ComparedValues> ResultDistances(const fs::path& run_a, const fs::path& run_b,
                                            const std::vector<CategorySpec>& specs,
                                            const ObjectEvaluationOptions& options) {
  const std::vector<TimedPose> cameras_a = ReadCameraPath(run_a), cameras_b = ReadCameraPath(run_b);
  const TrajectoryEvaluation moved = EvaluateTrajectory(
      cameras_b, cameras_a,
      {.alignment = options.alignment, .first_n = options.first_n, .tolerance = options.tolerance});
  if (moved.poses.empty()) return {};
  std::vector<ComparedValues> distances =
      ObjectDistances(run_a, Moved(LoadObjects(run_b), moved.alignment), specs, options.gate_m);
  ComparedValues& cameras = distances.emplace_back(ComparedValues{kCameraDistance, 4, {}, 0, 0});
  for (const PoseError& pose : moved.poses)
    AddDistance(cameras, {"", Microseconds(pose.timestamp)}, pose.position);
  cameras.only_a = cameras_a.size() - cameras.pairs.size();
  cameras.only_b = cameras_b.size() - cameras.pairs.size();
  std::erase_if(distances,
                [](const ComparedValues& of) { return of.pairs.size() + of.only_a + of.only_b == 0; });
  return distances;
}

Table DistanceTable(const std::vector<ComparedValues>& distances) {
  Table table;
  table.columns = {"of B from A", "median", "mean", "max", "pairs", "only A", "only B"};
  for (const ComparedValues& values : distances) table.rows.push_back(DistanceRow(values));
  table.notes = {"No truth says which of them is better: B is looked at as if A were the truth."};
  return table;
}

}  // namespace armature
