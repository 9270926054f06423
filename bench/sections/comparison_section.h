// SPDX-License-Identifier: BSD-3-Clause
// The paper's comparison: engines side by side on the frames with a given number of objects, stage by stage.
#pragma once

#include "bench/bench_report.h"
#include "bench/sections/bench_task.h"

namespace armature {

// Throws InputError when no frame after the warm-up has the wanted number of objects. `objects`: one a frame.
void CheckHasComparedFrames(const std::string& sequence, const std::vector<size_t>& objects,
                            const BenchSettings& settings);

// Requires such a frame.
BenchSection ComparisonSection(const BenchTask& task);

// A row a stage, a column an engine, medians; the paper's own figures beside.
Table StageTable(const std::vector<BenchRow>& rows, const std::vector<std::string>& engines, size_t objects);

// A row a stage and engine.
Table StatisticsTable(const std::vector<NamedSpan>& spans);

// How many times as long each other engine takes as `ours`, paired by frame.
Table RatioTable(const std::vector<NamedRatio>& ratios, const std::string& ours, size_t objects);

}  // namespace armature
