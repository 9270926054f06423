// SPDX-License-Identifier: BSD-3-Clause
// The nearest instances in libraries of growing size: methods of the index side by side with an exact scan.
#pragma once

#include <string>
#include <vector>

#include "bench/bench_report.h"

namespace armature {

struct RetrievalSetup {
  std::vector<size_t> sizes;  // instances, each once, growing
  size_t queries = 400;       // of each size and method, of an exact scan fewer; more than kRetrievalWarmUp
};

// The texts as sizes, each once, growing. Throws InputError for what is not a number from 1 to five millions,
// of which FLANN can still count the memory.
std::vector<size_t> RetrievalSizes(const std::vector<std::string>& texts);

// Spans: contender "kdtree:128 of 1000000", stage "query"; a curve a contender.
BenchSection RetrievalSection(const RetrievalSetup& setup);

}  // namespace armature
