// SPDX-License-Identifier: BSD-3-Clause
#include "io/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

namespace armature {
namespace {

constexpr long kBarWidth = 30;
constexpr std::chrono::milliseconds kBetweenBars{100};

}  // namespace

Progress::Progress(std::string what, long total)
    : Progress(std::move(what), total, std::cerr, isatty(STDERR_FILENO) != 0) {}

Progress::Progress(std::string what, long total, std::ostream& stream, bool is_terminal)
    : what_(std::move(what)), total_(std::max(total, 1L)), stream_(stream), is_terminal_(is_terminal) {}

Progress::~Progress() {
  if (!is_terminal_ || done_ == 0) return;
  DrawBar();
  stream_ << '\n' << std::flush;
}

void Progress::Step() {
  ++done_;
  if (is_terminal_) {
    if (std::chrono::steady_clock::now() - drawn_ >= kBetweenBars) DrawBar();
    return;
  }
  const long tenths = 10 * done_ / total_;
  if (tenths <= tenths_shown_) return;
  tenths_shown_ = tenths;
  stream_ << fmt::format("{} {}/{} ({} %)\n", what_, done_, total_, 10 * tenths) << std::flush;
}

void Progress::DrawBar() {
  const long filled = std::min(kBarWidth, kBarWidth * done_ / total_);
  stream_ << fmt::format("\r{} [{:=<{}}{:<{}}] {}/{}", what_, "", filled, "", kBarWidth - filled, done_,
                         total_)
          << std::flush;
  drawn_ = std::chrono::steady_clock::now();
}

}  // namespace armature
