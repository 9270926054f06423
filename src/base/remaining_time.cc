// SPDX-License-Identifier: BSD-3-Clause
#include "base/remaining_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace armature {
namespace {

constexpr double kLeastWindow = 10;  // seconds
constexpr double kSamplesAWindow = 100;

double Window(double seconds) { return std::max(kLeastWindow, seconds / 3); }

}  // namespace

void RemainingTime::Add(long done, double seconds) {
  const double window = Window(seconds);
  // The newest sample moves on until it is far enough from the one before: as many are kept for hours of
  // work.
  const size_t count = recent_.size();
  if (count > 1 && seconds - recent_[count - 2].seconds < window / kSamplesAWindow) recent_.pop_back();
  recent_.push_back({done, seconds});
  while (recent_.size() > 2 && recent_[1].seconds < seconds - window) recent_.pop_front();
}

std::optional<double> RemainingTime::Seconds(long total) const {
  const Sample& first = recent_.front();
  const Sample& last = recent_.back();
  if (last.seconds < 1 || last.done < 2 || last.done == first.done) return std::nullopt;
  const double pace = (last.seconds - first.seconds) / static_cast<double>(last.done - first.done);
  return pace * static_cast<double>(std::max(total - last.done, 0L));
}

std::string DurationText(double seconds) {
  const long all = std::lround(seconds);
  const long hours = all / 3600, minutes = all / 60 % 60;
  if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, minutes, all % 60);
  return fmt::format("{}:{:02}", minutes, all % 60);
}

}  // namespace armature
