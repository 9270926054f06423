// SPDX-License-Identifier: BSD-3-Clause
// Values of two results, brought together by what they are of.
#pragma once

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/paired_difference.h"
#include "io/text_table.h"

namespace armature {

// What a value is of: an object, a frame, a detection of an object, a repetition's frame.
struct ValueKey {
  std::string series;  // an object's id, a repetition, or empty: neighbours in it are alike
  std::optional<long long> microseconds{};  // its time
  int index = 0;                            // among those of its time; a frame
  auto operator<=>(const ValueKey&) const = default;
};

struct NamedValues {
  std::string name;  // "object centre [m]"
  int digits = 3;    // as it is shown
  std::map<ValueKey, double> values{};
};

// A quantity that both results have.
struct ComparedValues {
  std::string name;
  int digits = 3;
  std::vector<std::pair<ValueKey, ValuePair>> pairs;  // by series and time
  size_t only_a = 0, only_b = 0;                      // values that the other does not have
};

// By name, in the order of `a`; quantities that only one of them has are left out.
std::vector<ComparedValues> PairValues(const std::vector<NamedValues>& a, const std::vector<NamedValues>& b);

// A row a quantity, whatever the number of its pairs.
Table DifferenceTable(const std::vector<ComparedValues>& compared);

// A quantity's difference, none without pairs.
std::optional<PairedDifference> ComputeDifference(const ComparedValues& compared);

// Raw rows, one a pair: "result,sequence,quantity,series,timestamp,index,a,b,difference".
std::string RawPairColumns();
std::string RawPairRows(const std::string& result, const std::string& sequence,
                        const std::vector<ComparedValues>& compared);

}  // namespace armature
