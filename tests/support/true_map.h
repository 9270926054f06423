// SPDX-License-Identifier: BSD-3-Clause
// Maps that a run could have made of a true world, and their files.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "eval/trajectories/trajectory_alignment.h"
#include "io/placed_objects.h"
#include "support/true_world.h"

namespace armature::testing {

// The true objects as a map: "map_ID" with 5 observations each.
inline std::vector<PlacedObject> TrueMap(const GroundTruth& truth) {
  std::vector<PlacedObject> map;
  for (const TrueObject& object : truth.objects) {
    map.push_back(
        {"map_" + object.id, object.category, "", object.T_world_object, object.size, 5, {0.5, -1}});
  }
  return map;
}

// As objects.csv.
inline std::string MapText(const std::vector<PlacedObject>& map) {
  std::string text = "id,category,instance,tx,ty,tz,qx,qy,qz,qw,size_x,size_y,size_z,observations,shape\n";
  for (const PlacedObject& object : map) {
    text += fmt::format("{},{},{},{},{:.12f},{:.12f},{:.12f},{},{}\n", object.id, object.category,
                        object.instance, PoseText(object.T_world_object, ","), object.size.x(),
                        object.size.y(), object.size.z(), object.observations, fmt::join(object.shape, ";"));
  }
  return text;
}

// The camera's true trajectory in another world, x_run = T_run_truth x_truth, as trajectory.txt.
inline std::string TrajectoryText(const GroundTruth& truth, const Similarity& T_run_truth) {
  std::string text;
  for (const TimedPose& pose : truth.T_world_camera)
    text += fmt::format("{:.6f} {}\n", pose.timestamp, PoseText(T_run_truth.Apply(pose.pose), " "));
  return text;
}

// Writes a map into a run folder, both files of it, as a run in the other world would.
inline void WriteMap(const TrueWorld& world, const std::string& run, std::vector<PlacedObject> map,
                     const Similarity& T_run_truth) {
  for (PlacedObject& object : map) {
    object.T_world_object = T_run_truth.Apply(object.T_world_object);
    object.size *= T_run_truth.scale;
  }
  for (const char* file : {"/objects.csv", "/objects_odometry.csv"})
    world.folder.Write(run + file, MapText(map));
  for (const char* file : {"/trajectory.txt", "/odometry_scaled.txt"})
    world.folder.Write(run + file, TrajectoryText(world.sequence.truth, T_run_truth));
}

}  // namespace armature::testing
