// SPDX-License-Identifier: BSD-3-Clause
#include "base/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string_view>

#include "base/text.h"

namespace armature {
namespace {

constexpr size_t kMostListed = 12;

constexpr int kOtherGroup = 3;  // edits that the right last part in the wrong group counts as

constexpr size_t kMostCompared = 100;  // characters; the rest of a longer name says no more

// What a name is compared by: its start, in small letters.
std::string Compared(const std::string& name) {
  std::string compared = name.substr(0, kMostCompared);
  for (char& c : compared) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return compared;
}

std::string LastPart(const std::string& name) { return name.substr(name.rfind('.') + 1); }

int DistanceToKnown(const std::string& name, const std::string& known) {
  const int whole = EditDistance(name, known);
  if (known.find('.') == std::string::npos) return whole;
  if (name.find('.') == std::string::npos) return std::min(whole, EditDistance(name, LastPart(known)) + 1);
  return LastPart(name) == LastPart(known) ? std::min(whole, kOtherGroup) : whole;
}

}  // namespace

int EditDistance(std::string_view a, std::string_view b) {
  // Three rows of the table: the last but one, the last, and the one that is filled.
  std::vector<int> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (size_t i = 1; i <= a.size(); ++i) {
    std::swap(before, above);
    std::swap(above, row);
    row[0] = static_cast<int>(i);
    for (size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string NearestName(const std::string& name, const std::vector<std::string>& known) {
  const std::string shortened = Compared(name);
  std::string nearest;
  int least = std::numeric_limits<int>::max();
  for (const std::string& candidate : known) {
    const int distance = DistanceToKnown(shortened, Compared(candidate));
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string UnknownNameMessage(const std::string& what, const std::string& name,
                               const std::vector<std::string>& known) {
  if (known.empty()) return fmt::format("unknown {} {}; none is known", what, Quoted(name));
  std::string message =
      fmt::format("unknown {} {}; did you mean {}?", what, Quoted(name), Quoted(NearestName(name, known)));
  if (known.size() > kMostListed) return message;
  return fmt::format("{} (known: {})", message, fmt::join(known, ", "));
}

}  // namespace armature
