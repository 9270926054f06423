// SPDX-License-Identifier: BSD-3-Clause
// Statistics over rooms in `armature eval`: a sequence is a room.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "eval/eval_inputs.h"
#include "eval/evaluation.h"
#include "eval/objects/eval_objects.h"

namespace armature {

// The kinds of tables over rooms, in the order in which they are printed. They are made when they are asked
// for.
inline const std::vector<std::string> kRoomTableNames{
    "rooms", "room_differences", "error_budget", "stability", "worst_rooms", "room_factors", "room_groups"};

// Where raw rows go; empty: nowhere.
struct RawRoomFiles {
  std::filesystem::path objects;  // a row a variant, room and object
  std::filesystem::path rooms;    // a row a variant and room
};

// The named tables, and records. The last three kinds are of the first variant alone; stability is left out
// where no run was jittered. Throws InputError: a bad argument, a malformed or missing file, a file that
// cannot be written.
Evaluation MakeRunRoomTables(const std::vector<RunToEvaluate>& runs, const std::vector<CategoryModel>& models,
                             const std::vector<std::string>& names, const ObjectArguments& arguments,
                             const RawRoomFiles& raw);

}  // namespace armature
