// SPDX-License-Identifier: BSD-3-Clause
// Frames with what a run found in them, drawn from its files.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "eval/report/report_data.h"
#include "eval/report/sequence_runs.h"
#include "pipeline/frame_result.h"

namespace armature {

// What observations.csv and associations.csv tell of the image. Without the segments that match no edge and
// what was before the resection: runs do not keep them.
FrameResult RestoreFrame(const LoadedRun& run, const Sequence& sequence, size_t image,
                         const std::vector<CategoryModel>& models);

// Of as many parts of equal length the place with the most; of equal ones the one nearest to the
// part's middle. Parts of nothing but zeros have none. By growing place.
std::vector<size_t> PickRichestParts(const std::vector<size_t>& counts, size_t parts);

// Of the first run, spread over the sequence, those with more objects preferred. A remark where an image
// cannot be read.
std::vector<OverlayFrame> MakeOverlayFrames(const SequenceRuns& sequence,
                                            const std::vector<CategoryModel>& models,
                                            std::vector<std::string>& remarks);

}  // namespace armature
