// SPDX-License-Identifier: BSD-3-Clause
// How long errors stay.
#pragma once

#include <optional>
#include <vector>

#include "geometry/box.h"

namespace armature {

// The errors of one thing, by growing times.
struct ErrorSeries {
  std::vector<double> times;  // seconds
  std::vector<double> errors;
};

// The correlation of errors with those of the same series `lag` seconds (within a quarter) later, about the
// mean of all series. None of fewer than ten pairs.
std::optional<double> CorrelationAfter(const std::vector<ErrorSeries>& series, double lag);

// The mean length [s] of runs of `true`; the frames are `step` seconds apart. None without any.
class RunLengths {
 public:
  // Another thing, or the same after a while in which it could not be observed.
  void Break() { was_on_ = false; }
  void Add(bool is_on);
  std::optional<double> Mean(double step) const;

 private:
  long runs_ = 0, frames_ = 0;
  bool was_on_ = false;
};

// The same of boxes that go on as long as one in the next frame overlaps them by half (intersection over
// union).
class BoxLengths {
 public:
  void AddFrame(const std::vector<Box>& boxes);
  std::optional<double> Mean(double step) const;

 private:
  std::vector<Box> last_;
  long begun_ = 0, all_ = 0;
};

}  // namespace armature
