// SPDX-License-Identifier: BSD-3-Clause
// The family of chairs: four legs, a seat, a back; with or without arms. Built in the frame of the object (y
// up, front +z), whose origin is here on the floor below the middle of the seat's rear edge; metres.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "drawing/mesh.h"

namespace armature {

enum class ChairBack {
  kShell,   // one plate from the seat to the top, without posts
  kPanel,   // a plate between posts
  kSlats,   // upright slats between two rails
  kLadder,  // rails one above the other
};

enum class Stretchers { kNone, kSides, kH, kAround };

struct ChairParameters {
  // What the wireframe shows. The seat's rear corners lie on the axes of the posts, which the rear legs
  // continue; widths are between corners and between the centres of feet.
  double seat_height = 0.45;  // of the seat's upper side at its rear
  double seat_rise = 0.0;     // how much higher its front is
  double seat_depth = 0.41;
  double rear_width = 0.43, front_width = 0.45;  // of the seat
  double height = 0.89;                          // of the back's top
  double back_width = 0.44;                      // at the top
  double recline = 0.07;                         // how far the back's top is behind the seat's rear
  double rear_feet = 0.45, front_feet = 0.46;
  double rear_rake = 0.07;    // how far the rear feet are behind the seat's rear
  double front_rake = -0.01;  // how far the front feet are before the seat's front

  // What only the solid shows.
  ChairBack back = ChairBack::kSlats;
  double back_thickness = 0.02;
  double back_gap = 0.12;  // between the seat and the lowest piece of the back, with posts only
  double rail = 0.06;      // height of a rail
  int bars = 4;            // slats or rails
  bool arms = false;
  double arm_height = 0.21;  // above the seat
  double arm_length = 0.8;   // share of the seat's depth
  double leg = 0.035;        // thickness of legs and posts; thin ones are of metal
  double leg_taper = 0.7;    // thickness at the floor, share of `leg`
  bool round_legs = false;
  double seat_thickness = 0.035;  // without cushion
  double cushion = 0.0;           // its thickness; its upper side is the seat's; 0: none
  Stretchers stretchers = Stretchers::kNone;
  double stretcher_height = 0.16;
};

struct ChairMaterials {
  Material frame, seat, back;
};

// Edges in the order of ChairEdgeNames(): back top, left, right; seat rear, front, left, right; legs front
// left, rear left, rear right, front right.
Wireframe ChairWireframe(const ChairParameters& parameters);
std::vector<std::string> ChairEdgeNames();

Mesh ChairMesh(const ChairParameters& parameters, const ChairMaterials& materials);

// `count` members drawn from the family's distribution (datasets/README.md); the same for the same seed on
// every platform, and the first n are the same whatever the count.
std::vector<ChairParameters> SampleChairFamily(int count, std::uint64_t seed);

}  // namespace armature
