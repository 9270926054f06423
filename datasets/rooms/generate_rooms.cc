// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/rooms/generate_rooms.h"

#include <fmt/format.h>

#include <exception>

#include "base/errors.h"
#include "datasets/rooms/draw_room.h"
#include "datasets/rooms/room_text.h"
#include "datasets/scene/scene_yaml.h"
#include "io/atomic_write.h"
#include "io/output_folder.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

std::string SplitName(std::uint64_t seed) {
  if (seed == kDevelopmentSeed) return "development";
  return seed == kCheckSeed ? "check" : std::to_string(seed);
}

Replaceable NoFolder() {
  return {"a folder that is being written", [](const fs::path&) { return false; }};
}

// Draws one into the folder and reads it again as a scene.
RoomFile WriteRoom(const Recipe& recipe, const Furniture& furniture, const RoomsToMake& rooms, int number,
                   const fs::path& folder) {
  const std::string name = RoomName(recipe, rooms, number);
  const DrawnRoom room = DrawRoom(recipe, furniture, {rooms.seed, number, name});
  const fs::path file = folder / (name + ".yaml");
  WriteFile(file,
            fmt::format("# Drawn from the recipe {}. Copy it to change it: it is written again with its "
                        "room.\n{}",
                        recipe.name, RoomText(room)));
  try {
    return {file, RoomPlan(ReadScene(file, furniture.collection), std::to_string(number))};
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: room {} is no scene as it is drawn: {}", recipe.file.string(), number,
                                 error.what()));
  }
}

}  // namespace

std::string RoomName(const Recipe& recipe, const RoomsToMake& rooms, int number) {
  return fmt::format("{}-{}-{:03}", recipe.name, SplitName(rooms.seed), number);
}

std::vector<RoomFile> WriteRooms(const Recipe& recipe, const Furniture& furniture, const RoomsToMake& rooms,
                                 const fs::path& out) {
  const OutputFolder aside(out / "drawing", NoFolder());  // until all are right
  std::vector<RoomFile> files(static_cast<size_t>(rooms.count));
  std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic)
  for (int i = 0; i < rooms.count; ++i) {
    bool is_over = false;
#pragma omp critical(write_rooms)
    is_over = failure != nullptr;
    if (is_over) continue;
    try {
      files[static_cast<size_t>(i)] = WriteRoom(recipe, furniture, rooms, rooms.first + i, aside.partial());
    } catch (...) {
#pragma omp critical(write_rooms)
      if (!failure) failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
  for (RoomFile& file : files) {
    const fs::path to = out / file.scene.filename();
    fs::rename(file.scene, to);
    file.scene = to;
  }
  return files;
}

}  // namespace armature
