// SPDX-License-Identifier: BSD-3-Clause
// What rooms are drawn from (datasets/README.md, "Rooms from a recipe"). Lengths are metres, angles degrees.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "datasets/rooms/drawn_section.h"

namespace armature {

struct CameraRecipe {
  Distribution size = Choice({"640x480"});  // pixels
  Distribution focal = Uniform(0.8, 1.05);  // of the longer side
};

struct RoomRecipe {
  Distribution width = Uniform(4.5, 7.5), depth = Uniform(4, 6.5), height = Uniform(2.4, 2.8);
  Distribution floor = Choice({"boards", "carpet", "tiles", "plain"}, {4, 3, 2, 1});
  Distribution walls = Choice({"plain", "boards", "tiles"}, {8, 1, 1});
  Distribution pictures = Uniform(2, 7), clutter = Uniform(2, 8), table_clutter = Uniform(0, 3);
  Distribution seat_clutter = Constant(0.1);  // share of chairs with something on them
  Distribution lamps = Uniform(1, 3), warmth = Uniform(0, 1);
};

struct GroupRecipe {
  enum class Kind { kDining, kDesk, kMeeting, kFree };

  Kind kind = Kind::kFree;
  Distribution count = Constant(1);
  Distribution chairs = Uniform(2, 6);    // at a table
  Distribution gap = Uniform(-0.3, 0.2);  // from a table's edge to a chair's front; below 0: pushed under
  Distribution turned_deg = Normal(0, 10, -40, 40);            // of a chair against its table
  Distribution laptops = Uniform(0, 1);                        // on a table
  Distribution category = Choice({"chair", "table"}, {2, 1});  // of a free-standing piece
};

// How large things are: the measures that a category's scale is known by.
struct FurnitureRecipe {
  Distribution seat_height = Normal(0.45, 0.03, 0.36, 0.54);
  Distribution chair_size = Normal(1, 0.06, 0.82, 1.18);  // of width and depth
  Distribution table_height = Mixture(
      {Normal(0.74, 0.025, 0.66, 0.82), Normal(0.45, 0.06, 0.3, 0.58), Normal(1.05, 0.05, 0.92, 1.18)},
      {17, 2, 1});
  Distribution laptop_width = Uniform(0.29, 0.40), lid_deg = Uniform(85, 130);
  Distribution alike = Constant(0.75);  // how likely chairs of a table are of one model
};

struct DistractorRecipe {
  Distribution count = Uniform(0, 3);
  Distribution shape = Choice({"sofa", "stool", "cabinet", "shelf", "plant", "round_table"});
  Distribution hiding = Constant(0.5);  // share that stands before some furniture, not at a wall
};

struct PathRecipe {
  Distribution kind = Choice({"handheld"});
  Distribution height = Uniform(0.9, 1.8);
  Distribution pitch_deg = Uniform(0, 35);
  Distribution speed =
      Uniform(0.25, 0.6);                // metres a second; of loop and turn: as fast as fps and frames say
  Distribution shake = Uniform(0.3, 1);  // 0: as on rails, 1: of a hand
  Distribution pauses = Uniform(0, 2);   // where the camera stands still, or turns without moving
  Distribution distance = Uniform(0.5, 1);    // of close, from the furniture
  Distribution overlap = Uniform(0.05, 0.2);  // of loop and turn
};

struct Recipe {
  std::filesystem::path file;
  std::string name, about;
  std::vector<Recipe> mixture;  // others; then nothing below counts
  std::vector<double> weights;  // of the mixture, add up to more than 0

  Distribution frames = Constant(60), fps = Choice({"3", "4", "5", "6"});
  double light_grid = 0.05;
  CameraRecipe camera;
  RoomRecipe room;
  std::vector<GroupRecipe> layout;
  FurnitureRecipe furniture;
  DistractorRecipe distractors;
  PathRecipe path;
  DrawnSection effects, odometry, detections;
};

// Throws InputError naming file, line and remedy.
Recipe ReadRecipe(const std::filesystem::path& file);

}  // namespace armature
