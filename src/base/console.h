// SPDX-License-Identifier: BSD-3-Clause
// The doors to standard error (notes, details and errors, a line each) and to standard output (results). What
// others named may stand in any of them: it is printed as printable.h has it.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace armature {

enum class Verbosity {
  kQuiet,    // errors only
  kNormal,   // and notes and progress
  kVerbose,  // and details
};

// Of the whole program; kNormal until it is set. To be set before threads are started.
void SetVerbosity(Verbosity verbosity);
Verbosity GetVerbosity();

// "armature: LINE": what the user would otherwise wonder at.
void Note(std::string_view line);

// The same for the first line of each kind only: what is so of a thousand files is told of one. From any
// thread.
void NoteOnce(std::string_view kind, std::string_view line);

// "armature: LINE": what is read, where settings come from, how long steps take; for --verbose.
void Detail(std::string_view line);

// "armature: LINE" whatever the verbosity, red on a terminal; line breaks become spaces.
void PrintError(std::string line);

// Lines for standard output, as they are.
void PrintResult(std::string_view text);

// A Detail with the seconds of a step, told when the step ends well.
class StepDetail {
 public:
  // `what`: "seq1: map"
  explicit StepDetail(std::string what);
  ~StepDetail();
  StepDetail(const StepDetail&) = delete;
  StepDetail& operator=(const StepDetail&) = delete;

 private:
  std::string what_;
  int exceptions_;  // on their way when the step began
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// What standard error can show.
struct Screen {
  bool is_terminal = false;  // one where a line can be drawn again: no TERM=dumb
  bool colour = false;       // a terminal, and NO_COLOR is not set (no-color.org)
};
Screen StandardErrorScreen();

// Columns of the terminal at standard error now, 80 where they are not known.
int TerminalColumns();

}  // namespace armature
