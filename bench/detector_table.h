// SPDX-License-Identifier: BSD-3-Clause
// The table of `armature bench detectors`.
#pragma once

#include <string>
#include <vector>

#include "bench/detector_bench.h"
#include "io/text_table.h"

namespace armature {

// A row a detector and set of parameters. Recall: a column a category that has known edges, and one of all.
Table DetectorTable(const std::string& sequence, size_t images, const std::vector<DetectorTiming>& timings);

}  // namespace armature
