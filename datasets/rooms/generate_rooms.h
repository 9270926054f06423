// SPDX-License-Identifier: BSD-3-Clause
// Draws rooms from a recipe and renders them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "datasets/rooms/furniture_choice.h"
#include "datasets/rooms/recipe.h"
#include "datasets/rooms/room_sheet.h"

namespace armature {

// The two splits that are published: look at development as often as you like, run check only to report.
constexpr std::uint64_t kDevelopmentSeed = 1, kCheckSeed = 1000001;

struct RoomsToMake {
  int first = 0, count = 0;  // numbers of the rooms, from 0
  std::uint64_t seed = kDevelopmentSeed;
};

// NAME-SPLIT-KKK: the recipe's name, `development`, `check` or the seed, and the room's number.
std::string RoomName(const Recipe& recipe, const RoomsToMake& rooms, int number);

// Draws the rooms, by all threads, and writes each as a scene file OUT/NAME-SPLIT-KKK.yaml; their plans, in
// the order of the files. Room k of a seed is the same whatever else is drawn. Throws InputError, and then
// has written nothing: a room that cannot be drawn, or is none that scenes can have.
struct RoomFile {
  std::filesystem::path scene;
  cv::Mat3b plan;
};
std::vector<RoomFile> WriteRooms(const Recipe& recipe, const Furniture& furniture, const RoomsToMake& rooms,
                                 const std::filesystem::path& out);

}  // namespace armature
