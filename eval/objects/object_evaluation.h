// SPDX-License-Identifier: BSD-3-Clause
// The objects of a map against the true ones.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "eval/objects/object_matching.h"
#include "eval/trajectories/trajectory_alignment.h"
#include "io/placed_objects.h"
#include "truth/ground_truth.h"
#include "truth/orientation_error.h"

namespace armature {

// A matched object against the truth.
struct ObjectError {
  double centre_m = 0;              // distance of the centres of the boxes
  OrientationError orientation;     // degrees, under the nearest symmetric turn
  Eigen::Vector3d size_m{0, 0, 0};  // estimated - true, along the object's axes under that turn
  double iou = 0;                   // common volume of the boxes over that of both, 0..1
  double mean_size_m() const { return size_m.cwiseAbs().mean(); }
};

enum class ObjectStatus {
  kFound,          // a map object is matched to it
  kMissed,         // it was detected in some image, and no map object is matched to it
  kNeverObserved,  // no detection is of it, nor was it found: nobody could have
  kSpurious        // a map object that is matched to no true one
};
std::string StatusName(ObjectStatus status);  // "found", "missed", "never observed", "spurious"

// A true object with what was found of it, or a spurious one.
struct EvaluatedObject {
  ObjectStatus status = ObjectStatus::kMissed;
  std::string category;
  std::string true_id;               // in objects_gt.csv; empty: spurious
  std::string map_id;                // in objects.csv; empty: none
  int observations = 0;              // of the map object
  std::optional<ObjectError> error;  // of found ones
};

// The map brought to the truth's frame; sizes are scaled too.
std::vector<PlacedObject> Moved(std::vector<PlacedObject> map, const Similarity& T_truth_run);

// Both in the frame of the truth. `symmetry_order`: see CategorySpec.
ObjectError CompareObject(const PlacedObject& object, const TrueObject& truth, int symmetry_order);

// All true objects in the order of the truth, then the spurious ones in the order of the map. `map` in the
// frame of the truth. Throws InputError when a true object's category has no specification.
std::vector<EvaluatedObject> EvaluateObjects(const std::vector<PlacedObject>& map, const GroundTruth& truth,
                                             const std::vector<CategorySpec>& specs,
                                             const ObjectPairs& pairs);

// Means and medians are over the found ones; with found = 0 they mean nothing.
struct ObjectSummary {
  int objects = 0;   // true ones
  int observed = 0;  // of them in some detection, or found: found + missed
  int found = 0, missed = 0, spurious = 0;
  double best_m = 0, worst_m = 0, average_m = 0, median_m = 0;  // distances of the centres
  double average_azimuth_deg = 0;                               // absolute
  double average_tilt_deg = 0;
  double average_size_m = 0;  // absolute, over objects and axes
  double average_iou = 0;     // 0..1
};
// Of one category; all of them where it is empty.
ObjectSummary Summarise(const std::vector<EvaluatedObject>& objects, const std::string& category);

}  // namespace armature
