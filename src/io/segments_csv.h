// SPDX-License-Identifier: BSD-3-Clause
// segments.csv: the lines of each frame, found before the run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/segment.h"
#include "io/sequence.h"

namespace armature {

// timestamp,x1,y1,x2,y2: undistorted pixels. Per image, longest first; `images` by growing stamps. Throws
// InputError: a malformed file, a row without image, a segment of no length.
std::vector<std::vector<Segment>> ReadSegments(const std::filesystem::path& file,
                                               const std::vector<ImageEntry>& images);

// What such a file holds: the segments of each stamp.
std::string SegmentsText(const std::vector<double>& stamps,
                         const std::vector<std::vector<Segment>>& segments);

// Throws std::runtime_error when the file cannot be written.
void WriteSegments(const std::filesystem::path& file, const std::vector<double>& stamps,
                   const std::vector<std::vector<Segment>>& segments);

}  // namespace armature
