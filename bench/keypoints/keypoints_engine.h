// SPDX-License-Identifier: BSD-3-Clause
// The baseline that the paper compares with: keypoints of each detected object by a network, pose and shape
// from them. It has no weights; so the network is stood in for, in one of three ways, and the heat maps that
// its post-processing reads are drawn beforehand. What it finds means nothing, only what it takes does:
// FrameOutcome::estimates stay empty.
#pragma once

#include <memory>
#include <vector>

#include "bench/engine.h"
#include "category/category_model.h"
#include "pipeline/options.h"

namespace armature {

enum class KeypointsMode {
  kPublished,  // the published time of a forward pass is added, not waited for
  kWait,       // the published time is waited for, with jitter
  kHourglass,  // a network of the published size, with random weights, is run
};

// Every detection's category must be one of the models'. Of the options, the resection's count, and the
// box's.
std::unique_ptr<Engine> MakeKeypointsEngine(KeypointsMode mode, const Options& options,
                                            std::vector<CategoryModel> models);

}  // namespace armature
