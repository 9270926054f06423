// SPDX-License-Identifier: BSD-3-Clause
#include "base/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/text.h"

namespace armature {
namespace {

constexpr size_t kMostListed = 12;

constexpr int kOtherGroup = 3;  // edits that the right last part in the wrong group counts as

std::string LastPart(const std::string& name) { return name.substr(name.rfind('.') + 1); }

int DistanceToKnown(const std::string& name, const std::string& known) {
  const int whole = EditDistance(name, known);
  if (known.find('.') == std::string::npos) return whole;
  if (name.find('.') == std::string::npos) return std::min(whole, EditDistance(name, LastPart(known)) + 1);
  return LastPart(name) == LastPart(known) ? std::min(whole, kOtherGroup) : whole;
}

}  // namespace

int EditDistance(const std::string& a, const std::string& b) {
  const size_t columns = b.size() + 1;
  std::vector<std::vector<int>> cost(a.size() + 1, std::vector<int>(columns, 0));
  for (size_t i = 0; i <= a.size(); ++i) {
    for (size_t j = 0; j < columns; ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = static_cast<int>(i + j);
        continue;
      }
      cost[i][j] = std::min(
          {cost[i - 1][j] + 1, cost[i][j - 1] + 1, cost[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
    }
  }
  return cost[a.size()][b.size()];
}

std::string NearestName(const std::string& name, const std::vector<std::string>& known) {
  std::string nearest;
  int least = std::numeric_limits<int>::max();
  for (const std::string& candidate : known) {
    const int distance = DistanceToKnown(name, candidate);
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
