// SPDX-License-Identifier: BSD-3-Clause
// The times that the paper prints (Joshi et al., ICVGIP 2018, section 4, last part), for 856x480 images with
// 3 objects: its lines on an Intel i5 with 8 GB, the keypoint network on a Titan X with 12 GB. The paper does
// not say which stages the time an object is made of.
#pragma once

namespace armature::paper {

inline constexpr double kLineDetectionMs = 0.25;      // LSD, a frame
inline constexpr double kLinesPerObjectMs = 120;      // "processing time", an object
inline constexpr double kKeypointsPerObjectMs = 285;  // forward pass of the network, an object

// 360.25 ms for 3 objects.
constexpr double LinesMs(double objects) { return kLineDetectionMs + objects * kLinesPerObjectMs; }
// 855 ms for 3 objects.
constexpr double KeypointsMs(double objects) { return objects * kKeypointsPerObjectMs; }

}  // namespace armature::paper
