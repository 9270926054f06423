// SPDX-License-Identifier: BSD-3-Clause
#include "io/stamps.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace armature {
namespace {

// As seconds the year 5138, as milliseconds 1973; a thousand times that the same of microseconds, and so on.
constexpr double kLargestStamp = 1e11;

}  // namespace

std::optional<std::string> GuessStampUnit(double stamp) {
  if (std::abs(stamp) < kLargestStamp) return std::nullopt;
  if (std::abs(stamp) < 1e3 * kLargestStamp) return "milliseconds";
  return std::abs(stamp) < 1e6 * kLargestStamp ? "microseconds" : "nanoseconds";
}

std::string DescribeStampRange(double first, double last) {
  const auto unit = GuessStampUnit(last);
  return fmt::format("{:.15g} to {:.15g}{}", first, last, unit ? fmt::format(" ({}?)", *unit) : " s");
}

std::string DescribeDuration(double seconds) {
  constexpr double kHour = 3600, kDay = 24 * kHour, kYear = 365.25 * kDay;
  const std::array<std::pair<double, const char*>, 4> units{
      {{kYear, "years"}, {kDay, "days"}, {kHour, "hours"}, {1, "s"}}};
  for (const auto& [length, name] : units) {
    if (std::abs(seconds) >= 2 * length || length == 1)
      return fmt::format("{:.3g} {}", seconds / length, name);
  }
  return "";
}

}  // namespace armature
