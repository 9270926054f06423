// SPDX-License-Identifier: BSD-3-Clause
#include "eval/objects/object_evaluation.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/statistics.h"
#include "category/category_lookup.h"
#include "geometry/oriented_box.h"
#include "truth/observation_metrics.h"
#include "truth/visible_edges.h"

namespace armature {
namespace {

// The size along the axes of the object turned about y: the sides are exchanged after a quarter of a turn.
Eigen::Vector3d TurnedSize(const Eigen::Vector3d& size, const Eigen::Matrix3d& turn) {
  const bool exchanged = std::abs(turn(0, 2)) > std::abs(turn(0, 0));
  return exchanged ? Eigen::Vector3d(size.z(), size.y(), size.x()) : size;
}

std::set<size_t> ObservedObjects(const GroundTruth& truth) {
  std::set<size_t> observed;
  for (const auto& [key, object] : truth.detections) observed.insert(object);
  return observed;
}

EvaluatedObject FoundObject(const PlacedObject& object, const TrueObject& truth,
                            const std::vector<CategorySpec>& specs) {
  const int symmetry_order = FindSpec(specs, truth.category).symmetry_order;
  return {ObjectStatus::kFound,
          truth.category,
          truth.id,
          object.id,
          object.observations,
          CompareObject(object, truth, symmetry_order)};
}

double Mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

void SummariseErrors(const std::vector<ObjectError>& errors, ObjectSummary& summary) {
  const auto column = [&](auto value) {
    std::vector<double> values;
    for (const ObjectError& error : errors) values.push_back(value(error));
    return values;
  };
  const std::vector<double> centres = column([](const ObjectError& e) { return e.centre_m; });
  summary.best_m = *std::min_element(centres.begin(), centres.end());
  summary.worst_m = *std::max_element(centres.begin(), centres.end());
  summary.average_m = Mean(centres);
  summary.median_m = Median(centres);
  summary.average_azimuth_deg =
      Mean(column([](const ObjectError& e) { return std::abs(e.orientation.azimuth_deg); }));
  summary.average_tilt_deg = Mean(column([](const ObjectError& e) { return e.orientation.tilt_deg; }));
  summary.average_size_m = Mean(column([](const ObjectError& e) { return e.mean_size_m(); }));
  summary.average_iou = Mean(column([](const ObjectError& e) { return e.iou; }));
}

}  // namespace

std::string StatusName(ObjectStatus status) {
  switch (status) {
    case ObjectStatus::kFound:
      return "found";
    case ObjectStatus::kMissed:
      return "missed";
    case ObjectStatus::kNeverObserved:
      return "never observed";
    case ObjectStatus::kSpurious:
      return "spurious";
  }
  return "";
}

std::vector<PlacedObject> Moved(std::vector<PlacedObject> map, const Similarity& T_truth_run) {
  for (PlacedObject& object : map) {
    object.T_world_object = T_truth_run.Apply(object.T_world_object);
    object.size *= T_truth_run.scale;
  }
  return map;
}

ObjectError CompareObject(const PlacedObject& object, const TrueObject& truth, int symmetry_order) {
  ObjectError error;
  error.centre_m = (object.T_world_object.translation() - truth.T_world_object.translation()).norm();
  error.orientation =
      CompareOrientation(object.T_world_object.linear(), truth.T_world_object.linear(), symmetry_order);
  const Eigen::Matrix3d turn = TurnAboutY(symmetry_order, error.orientation.symmetry_step);
  error.size_m = object.size - TurnedSize(truth.size, turn);
  error.iou = IntersectionOverUnion({object.T_world_object, object.size}, {truth.T_world_object, truth.size});
  return error;
}

std::vector<EvaluatedObject> EvaluateObjects(const std::vector<PlacedObject>& map, const GroundTruth& truth,
                                             const std::vector<CategorySpec>& specs,
                                             const ObjectPairs& pairs) {
  const std::set<size_t> observed = ObservedObjects(truth);
  // Without knowing which were detected, none is excused.
  const auto is_observed = [&](size_t i) { return !truth.knows_detections || observed.contains(i); };
  std::vector<EvaluatedObject> evaluated;
  for (size_t i = 0; i < truth.objects.size(); ++i) {
    const TrueObject& object = truth.objects[i];
    const ObjectStatus status = is_observed(i) ? ObjectStatus::kMissed : ObjectStatus::kNeverObserved;
    evaluated.push_back({status, object.category, object.id, "", 0, std::nullopt});
  }
  std::vector<bool> is_matched(map.size(), false);
  for (const auto& [in_map, in_truth] : pairs) {
    evaluated[in_truth] = FoundObject(map[in_map], truth.objects[in_truth], specs);
    is_matched[in_map] = true;
  }
  for (size_t j = 0; j < map.size(); ++j) {
    if (is_matched[j]) continue;
    evaluated.push_back(
        {ObjectStatus::kSpurious, map[j].category, "", map[j].id, map[j].observations, std::nullopt});
  }
  return evaluated;
}

ObjectSummary Summarise(const std::vector<EvaluatedObject>& objects, const std::string& category) {
  ObjectSummary summary;
  std::vector<ObjectError> errors;
  for (const EvaluatedObject& object : objects) {
    if (!category.empty() && object.category != category) continue;
    summary.objects += object.status == ObjectStatus::kSpurious ? 0 : 1;
    summary.found += object.status == ObjectStatus::kFound ? 1 : 0;
    summary.missed += object.status == ObjectStatus::kMissed ? 1 : 0;
    summary.spurious += object.status == ObjectStatus::kSpurious ? 1 : 0;
    if (object.error) errors.push_back(*object.error);
  }
  summary.observed = summary.found + summary.missed;
  if (!errors.empty()) SummariseErrors(errors, summary);
  return summary;
}

}  // namespace armature
