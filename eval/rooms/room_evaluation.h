// SPDX-License-Identifier: BSD-3-Clause
// A run in its room - a sequence with a truth - as what statistics over rooms are made of.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/eval_inputs.h"
#include "eval/objects/run_objects.h"
#include "eval/rooms/circumstances.h"

namespace armature {

// A true object that could be seen: `of` is found or missed.
struct RoomObject {
  EvaluatedObject of;
  ObjectCircumstances circumstances;
};

struct EvaluatedRoom {
  std::string room;              // the sequence's name
  std::filesystem::path folder;  // of the run
  int jitter = 0;                // of the run; 0: none
  std::vector<RoomObject> objects{};
  int spurious = 0;
  std::optional<double> log_scale{};  // ln(estimated / true size of the camera's path); none: it hardly moved
  std::optional<double> ate_m{};      // rmse of the cameras' positions; none: no pose has a true one
  RoomCircumstances circumstances{};

  int observed() const { return static_cast<int>(objects.size()); }
  int found() const;
  // Of the found objects' centres; none where none is found.
  std::optional<double> mean_error_m() const;
};

// The map of the graph (not that by odometry), matched by distance. Throws InputError as EvaluateRunObjects.
EvaluatedRoom EvaluateRoom(const RunToEvaluate& run, const SequenceTruth& truth,
                           const std::vector<CategoryModel>& models, const ObjectEvaluationOptions& options);

// The rooms of one way of running.
struct RoomVariant {
  std::string name;
  std::vector<EvaluatedRoom> rooms;  // by name
};

// Runs in one given folder are of one variant, which has its name; of those given one by one, runs of one
// name. In the order of their first runs. Throws InputError: two of one variant and room, a sequence without
// truth of cameras and objects, as above.
std::vector<RoomVariant> EvaluateRooms(const std::vector<RunToEvaluate>& runs,
                                       const std::vector<CategoryModel>& models,
                                       const ObjectEvaluationOptions& options);

// Null: the variant has no run of the room.
const EvaluatedRoom* FindRoom(const RoomVariant& variant, const std::string& room);

}  // namespace armature
