// SPDX-License-Identifier: BSD-3-Clause
// The pictures of a section's numbers.
#pragma once

#include <filesystem>
#include <string>

#include "bench/bench_report.h"

namespace armature {

// Whether a table of that name is drawn.
bool IsDrawnTable(const std::string& table);

// Writes to the folder, which is there:
//   comparison-SEQUENCE.svg        medians of the stages as bars, the paper's with that many objects beside
//   objects-SEQUENCE.svg           medians with p10..p90, fitted lines and the paper's against the objects
//   scaling-LOAD-SEQUENCE.svg      the same of each load of bench/sections/load_variants.h
//   retrieval.svg                  medians of a query against the size of the library, a curve an index
// and nothing for other sections. Throws InputError as RunGnuplot.
void WriteSectionPlots(const BenchSection& section, size_t objects, const std::filesystem::path& folder);

}  // namespace armature
