// SPDX-License-Identifier: BSD-3-Clause
// Line detectors compared, each in a whole pipeline: how long they take, what they find, and how accurate the
// objects are that come of it.
#pragma once

#include "bench/bench_report.h"
#include "bench/sections/bench_task.h"
#include "bench/sections/findings.h"

namespace armature {

// A detector with its parameters, in the whole image or in the boxes only.
struct DetectorChoice {
  std::string parameters;  // "tuned", "half size", "published"
  LineOptions lines;
  std::string name;  // "lsd tuned whole image"
};

// Every detector with tuned and published parameters, in the whole image and in the boxes only; what else
// there is of the options stays.
std::vector<DetectorChoice> DetectorChoices(const LineOptions& options);

// All of them on the same frames.
BenchSection DetectorsSection(const BenchTask& task);

// Time and accuracy; `findings`: one a choice.
Table DetectorTable(const std::vector<DetectorChoice>& choices, const std::vector<BenchRow>& rows,
                    const std::vector<Findings>& findings);

// Which share of the true edges is beside some segment, by category.
Table RecallTable(const std::vector<DetectorChoice>& choices, const std::vector<Findings>& findings);

// The choice with the least median total of those whose accuracy is within 10 % of tuned LSD's in the whole
// image; -1 without truth.
int FastestAsAccurateAsLsd(const std::vector<DetectorChoice>& choices, const std::vector<BenchRow>& rows,
                           const std::vector<Findings>& findings);

}  // namespace armature
