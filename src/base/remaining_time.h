// SPDX-License-Identifier: BSD-3-Clause
// How long work still takes, from its recent pace.
#pragma once

#include <deque>
#include <optional>
#include <string>

namespace armature {

class RemainingTime {
 public:
  // `done` steps were done after `seconds` since the start; neither ever decreases.
  void Add(long done, double seconds);

  // Seconds until `total` steps are done at the pace of the last third of the time so far, at least the last
  // ten seconds: slow first steps (caches, files) are soon forgotten, single slow ones hardly count. None in
  // the first second and before two steps are done.
  std::optional<double> Seconds(long total) const;

 private:
  struct Sample {
    long done;
    double seconds;
  };
  std::deque<Sample> recent_{{0, 0}};  // the first is the newest that is older than the window
};

// "0:05", "1:20", "1:02:03"; rounded to seconds.
std::string DurationText(double seconds);

}  // namespace armature
