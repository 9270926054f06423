// SPDX-License-Identifier: BSD-3-Clause
// The true poses of cameras and objects of a sequence. For evaluation only: the pipeline never sees them.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/run_results.h"
#include "io/trajectory.h"

namespace armature {

struct TrueObject {
  std::string id;
  std::string category;
  std::string instance;  // "source:model", empty where the CAD model is not known
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();  // metres
  Eigen::Vector3d size{0, 0, 0};                                     // metres, along the object's axes
  int line = 0;                                                      // of objects_gt.csv
};

struct GroundTruth {
  std::vector<TimedPose> T_world_camera;
  std::vector<TrueObject> objects;
  std::string objects_source;  // the first comment of objects_gt.csv: where it is from; empty: none
  // Which object a detection is of: (timestamp in whole microseconds, index) -> position in `objects`.
  std::map<std::pair<long long, int>, size_t> detections;
  // The detections that are of no object: (timestamp in whole microseconds, index).
  std::vector<std::pair<long long, int>> false_alarms;
  bool knows_detections = true;  // false: which detections there were, and so what was seen, is not known

  // The true T_camera_object of a detection, none when it is of no true object (a false alarm).
  std::optional<Eigen::Isometry3d> TrueCameraObject(double timestamp, int index) const;
  const TrueObject* FindObject(double timestamp, int index) const;
};

// groundtruth.txt of a sequence folder, in any format that io/trajectory.h reads (KITTI: a line an
// image of rgb.txt), repeated stamps kept. Throws InputError.
std::vector<TimedPose> LoadTrueTrajectory(const std::filesystem::path& sequence);

// groundtruth.txt, objects_gt.csv and detections_gt.csv of a sequence folder. Throws InputError naming file
// and line: also for an object or detection that is there twice, a size that is not greater than 0, and an
// index that no detection of detections.csv (where the folder has one) has at the stamp.
GroundTruth LoadGroundTruth(const std::filesystem::path& sequence);

// What is true for a run: nothing of single detections where it had others than the sequence's own.
GroundTruth TruthOfRun(GroundTruth truth, const RunResults& run);

}  // namespace armature
