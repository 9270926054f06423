// SPDX-License-Identifier: BSD-3-Clause
// Progress on standard error: a bar on a terminal, a line each 10 % elsewhere.
#pragma once

#include <chrono>
#include <ostream>
#include <string>

namespace armature {

class Progress {
 public:
  // `what`: what is counted, "office_dev: frames".
  Progress(std::string what, long total);
  // Writing to a stream of the caller's choice.
  Progress(std::string what, long total, std::ostream& stream, bool is_terminal);
  // Ends the bar's line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // One more is done.
  void Step();

 private:
  void DrawBar();

  std::string what_;
  long total_;
  std::ostream& stream_;
  bool is_terminal_;
  long done_ = 0;
  long tenths_shown_ = 0;
  std::chrono::steady_clock::time_point drawn_{};
};

}  // namespace armature
