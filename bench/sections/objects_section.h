// SPDX-License-Identifier: BSD-3-Clause
// Time against the number of objects in a frame: a constant part and a part an object, and where two engines
// cross.
#pragma once

#include <string>

#include "bench/bench_report.h"
#include "bench/sections/bench_task.h"

namespace armature {

// The same frames with 1 to 20 detections each, all numbers in turn, each with a state of its own.
BenchSection ObjectsSection(const BenchTask& task);

// From how many objects on our engine is the faster one, as text: "none: ours is below from 1 object on".
std::string CrossoverText(const LineFit& ours, const LineFit& other);

// A row an engine: constant, part an object, time of the largest number over that of three, crossover. The
// paper's own lines and keypoints come last. `series`: one an engine, the first is ours.
Table ObjectFitTable(const std::vector<BenchSeries>& series);

}  // namespace armature
