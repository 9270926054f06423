// SPDX-License-Identifier: BSD-3-Clause
// Which frames the map is made of, so that neither its cost nor its confidence grows with the video once the
// room is known.
//
// What is wrong in a view from one place (matches, the wireframe itself) is wrong in the next one from there:
// many such views are no more evidence than a few. Were each to count in full, they would outweigh the
// categories' shapes, which is where metric scale comes from: with a camera going to and fro on one way the
// scale fell from 2.57 (truth 2.55) to 1.87 in 3000 frames. So a place keeps a number of frames, spread over
// time. The others are passed: they get a camera between the kept ones, and their detections objects.
#pragma once

#include <optional>

#include "mapping/solve_map.h"

namespace armature {

inline constexpr size_t kAlwaysKept = 250;  // frames: a map of so few is soon solved

// Of the frames that were taken where the last one was and show as much, one too many: that which leaves the
// least gap in time. None where there are few; never the first or last frame, nor one next to a jump.
std::optional<size_t> FindSuperfluousFrame(const std::vector<MapFrame>& frames,
                                           const std::vector<Eigen::Isometry3d>& T_world_camera);

// Makes the frame a passed one of the frame after it.
void PassOver(size_t index, std::vector<MapFrame>& frames);

// The map of all frames from the map of those that were kept: passed cameras go from kept camera to kept
// camera as the odometry does. `seconds_between`: as in AssociateFrame.
Map WithPassedFrames(const std::vector<MapFrame>& frames, const Map& map,
                     std::optional<double> seconds_between);

}  // namespace armature
