// SPDX-License-Identifier: BSD-3-Clause
#include "base/console.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <functional>
#include <mutex>
#include <set>

#include "base/printable.h"
#include "base/standard_streams.h"

namespace armature {
namespace {

Verbosity program_verbosity = Verbosity::kNormal;

// A bar of progress may be on the line.
const char* LineStart() { return StandardErrorScreen().is_terminal ? "\r\x1b[K" : ""; }

void PrintLine(std::string_view line) {
  PrintToStandardError(fmt::format("{}armature: {}\n", LineStart(), Printable(line)));
}

bool IsSet(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

}  // namespace

void SetVerbosity(Verbosity verbosity) { program_verbosity = verbosity; }

Verbosity GetVerbosity() { return program_verbosity; }

void Note(std::string_view line) {
  if (program_verbosity >= Verbosity::kNormal) PrintLine(line);
}

void NoteOnce(std::string_view kind, std::string_view line) {
  static std::mutex mutex;
  static std::set<std::string, std::less<>> told;
  const std::lock_guard lock(mutex);
  if (told.emplace(kind).second) Note(line);
}

void Detail(std::string_view line) {
  if (program_verbosity >= Verbosity::kVerbose) PrintLine(line);
}

void PrintError(std::string line) {
  std::replace(line.begin(), line.end(), '\n', ' ');
  const bool red = StandardErrorScreen().colour;
  PrintToStandardError(fmt::format("{}{}armature: {}{}\n", LineStart(), red ? "\x1b[31m" : "",
                                   Printable(line), red ? "\x1b[0m" : ""));
}

void PrintResult(std::string_view text) { fmt::print("{}", PrintableLines(text)); }

StepDetail::StepDetail(std::string what) : what_(std::move(what)), exceptions_(std::uncaught_exceptions()) {}

StepDetail::~StepDetail() {
  if (std::uncaught_exceptions() > exceptions_) return;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
  Detail(fmt::format("{}: {:.2f} s", what_, seconds.count()));
}

Screen StandardErrorScreen() {
  const char* terminal = std::getenv("TERM");
  const bool is_dumb = terminal != nullptr && std::string_view(terminal) == "dumb";
  Screen screen;
  screen.is_terminal = isatty(STDERR_FILENO) != 0 && !is_dumb;
  screen.colour = screen.is_terminal && !IsSet("NO_COLOR");
  return screen;
}

int TerminalColumns() {
  constexpr int kUnknown = 80;
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kUnknown;
  return size.ws_col;
}

}  // namespace armature
