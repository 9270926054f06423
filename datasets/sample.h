// SPDX-License-Identifier: BSD-3-Clause
// The built-in sample: a short, drawn sequence of a room with three chairs, a table and a laptop.
#pragma once

#include <cstdint>
#include <filesystem>

namespace armature {

struct SampleOptions {
  int frames = 24;         // the first so many of the same path, 1 to 24
  std::uint64_t seed = 1;  // of the noise in images, detections and odometry
};

// Writes the sequence folder with its ground truth; the same bytes for the same options. Throws InputError
// when something is at `folder` already.
void WriteSample(const std::filesystem::path& folder, const SampleOptions& options);

}  // namespace armature
