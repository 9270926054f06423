// SPDX-License-Identifier: BSD-3-Clause
// Sequences as the benchmarks need them: in memory before any clock starts, of another image size, or with a
// given number of objects a frame.
#pragma once

#include <string>

#include "bench/engine.h"
#include "io/sequence.h"

namespace armature {

// Throws InputError when none of the first `limit` frames (0: all) has an object.
void CheckHasObjects(const Sequence& sequence, size_t limit);

// The first `limit` images (0: all) as gray pictures. Throws as CheckHasObjects, and InputError for an image
// that cannot be read.
BenchSequence LoadBenchSequence(const Sequence& sequence, size_t limit);

// At most the first `count` frames; the pixels are shared.
BenchSequence FirstFrames(const BenchSequence& sequence, size_t count);

// The same pictures, camera and boxes in another size, in pixels; both axes are scaled on their own.
BenchSequence Resized(const BenchSequence& sequence, int width, int height);

// Frames with exactly so many detections each: the frame's own, largest first, and repeated in turn where
// there are fewer. A frame without any stays without; the pixels are shared.
struct FilledSequence {
  BenchSequence sequence;
  double repeated_share = 0;  // 0..1, of all its detections
};
FilledSequence WithObjects(const BenchSequence& sequence, size_t count);

// "856x480"
std::string ImageSize(const Camera& camera);

}  // namespace armature
