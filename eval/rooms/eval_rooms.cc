// SPDX-License-Identifier: BSD-3-Clause
#include "eval/rooms/eval_rooms.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/console.h"
#include "base/errors.h"
#include "eval/rooms/error_budget.h"
#include "eval/rooms/room_factors.h"
#include "eval/rooms/room_stability.h"
#include "eval/rooms/room_statistics.h"
#include "eval/rooms/worst_rooms.h"
#include "io/atomic_write.h"

namespace armature {
namespace {

std::vector<RoomDifferenceRecord> CompareWithFirst(const std::vector<RoomVariant>& variants) {
  std::vector<RoomDifferenceRecord> records;
  for (size_t i = 1; i < variants.size(); ++i) {
    auto more = CompareVariants(variants.front(), variants[i]);
    std::move(more.begin(), more.end(), std::back_inserter(records));
  }
  return records;
}

// Those whose sequences have what a room needs.
std::vector<RunToEvaluate> RunsInRooms(const std::vector<RunToEvaluate>& runs) {
  std::vector<RunToEvaluate> in_rooms;
  for (const RunToEvaluate& run : runs) {
    if (run.HasTruth("groundtruth.txt") && run.HasTruth("objects_gt.csv"))
      in_rooms.push_back(run);
    else
      NoteOnce(run.truth.string(),
               fmt::format(
                   "{}: is left out of tables over rooms: it has not both groundtruth.txt and objects_gt.csv",
                   run.truth.string()));
  }
  if (in_rooms.empty())
    throw InputError(
        fmt::format("{}: has not both groundtruth.txt and objects_gt.csv, nor has another sequence: "
                    "nothing to show over rooms",
                    runs.front().truth.string()));
  return in_rooms;
}

void WriteRaw(const std::vector<RoomVariant>& variants, const RawRoomFiles& raw) {
  if (!raw.objects.empty()) AtomicWrite(raw.objects, RawRoomObjectsCsv(variants));
  if (!raw.rooms.empty()) AtomicWrite(raw.rooms, RawRoomsCsv(variants));
}

}  // namespace

Evaluation MakeRunRoomTables(const std::vector<RunToEvaluate>& runs, const std::vector<CategoryModel>& models,
                             const std::vector<std::string>& names, const ObjectArguments& arguments,
                             const RawRoomFiles& raw) {
  const auto has = [&](const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  std::vector<RoomVariant> variants = EvaluateRooms(RunsInRooms(runs), models, MakeObjectOptions(arguments));
  WriteRaw(variants, raw);
  const std::vector<RepeatedVariant> repeated = TakeRepeats(variants);
  Evaluation made;
  EvaluationRecords& records = made.records;
  records.rooms = ComputeRoomStatistics(variants);
  records.room_differences = CompareWithFirst(variants);
  records.room_errors = CollectRoomErrors(variants);
  records.worst_rooms = FindWorstRooms(variants.front(), arguments.gate_m);
  if (has("rooms")) made.tables.push_back(RoomTable(variants, records.rooms));
  if (has("room_differences") && variants.size() > 1)
    made.tables.push_back(RoomDifferenceTable(records.room_differences));
  if (has("error_budget") && variants.size() > 1)
    made.tables.push_back(ErrorBudgetTable(variants, arguments.gate_m));
  if (has("stability") && !repeated.empty()) made.tables.push_back(StabilityTable(repeated));
  if (has("worst_rooms")) made.tables.push_back(WorstRoomTable(variants.front(), arguments.gate_m));
  if (has("room_factors")) made.tables.push_back(RoomFactorTable(variants.front()));
  if (has("room_groups")) made.tables.push_back(RoomGroupTable(variants.front()));
  return made;
}

}  // namespace armature
