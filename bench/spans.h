// SPDX-License-Identifier: BSD-3-Clause
// Durations of rows by name, and their statistics.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/harness.h"
#include "io/named_span.h"

namespace armature {

// Milliseconds of a stage (kBenchStageNames) or of one of the above. None: the engine has no such stage.
std::optional<double> FindDuration(const BenchRow& row, std::string_view span);

// Of one contender, in the order of the rows; those that have it.
std::vector<double> CollectDurations(const std::vector<BenchRow>& rows, const std::string& contender,
                                     std::string_view span);

// Median of such durations, none of nothing.
std::optional<double> MedianDuration(const std::vector<BenchRow>& rows, const std::string& contender,
                                     std::string_view span);

// The median of values, none of none.
std::optional<double> ComputeMedian(const std::vector<double>& values);

// Milliseconds of a span for each object, in those rows that have any.
std::vector<double> DurationsAnObject(const std::vector<BenchRow>& rows, const std::string& contender,
                                      std::string_view span);

// The contenders' stages and totals; a stage that never ran has none.
std::vector<NamedSpan> CollectSpans(const std::string& table, const std::string& sequence,
                                    const std::vector<BenchRow>& rows,
                                    const std::vector<std::string>& contenders);

// Of each other contender over the first, where they have runs in common.
std::vector<NamedRatio> CollectRatios(const std::string& table, const std::string& sequence,
                                      const std::vector<BenchRow>& rows,
                                      const std::vector<std::string>& contenders);

// Of two contenders in the same runs: the other's total over the reference's.
std::vector<double> PairedRatios(const std::vector<BenchRow>& rows, const std::string& other,
                                 const std::string& reference);

}  // namespace armature
