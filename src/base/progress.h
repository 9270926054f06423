// SPDX-License-Identifier: BSD-3-Clause
// Progress on standard error: on a terminal a bar with the time that is left, elsewhere a line each 10 %,
// nothing with --quiet.
#pragma once

#include <chrono>
#include <functional>
#include <ostream>
#include <string>

#include "base/console.h"
#include "base/remaining_time.h"

namespace armature {

// Where progress is shown.
struct ProgressScreen {
  std::ostream* stream = nullptr;  // none: nothing is shown
  Screen screen;
  std::function<int()> columns = TerminalColumns;  // of the terminal, asked for each bar: it may be resized
};

class Progress {
 public:
  // `what`: what is counted, "office_dev: frames".
  Progress(std::string what, long total);
  Progress(std::string what, long total, ProgressScreen screen);
  // Ends the bar's line, with the time that was taken.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // One more is done.
  void Step();

 private:
  double Elapsed() const;  // seconds
  void DrawBar(const std::string& time);

  std::string what_;
  long total_;
  ProgressScreen out_;
  long done_ = 0;
  long tenths_shown_ = 0;
  RemainingTime remaining_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point drawn_{};
};

}  // namespace armature
