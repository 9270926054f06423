// SPDX-License-Identifier: BSD-3-Clause
#include "base/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <optional>

#include "base/printable.h"

namespace armature {
namespace {

using Clock = std::chrono::steady_clock;

constexpr long kMostBar = 30;  // columns
constexpr long kLeastBar = 5;
constexpr std::chrono::milliseconds kBetweenBars{100};

ProgressScreen StandardError() {
  if (GetVerbosity() == Verbosity::kQuiet) return {};
  return {&std::cerr, StandardErrorScreen()};
}

// " [====      ]" in so many columns at most; nothing where there is no room.
std::string BarText(long done, long total, long columns, bool colour) {
  const long width = std::min(kMostBar, columns - 3);
  if (width < kLeastBar) return "";
  const long filled = std::min(width, width * done / total);
  return fmt::format(" [{}{:=<{}}{}{:<{}}]", colour ? "\x1b[32m" : "", "", filled, colour ? "\x1b[0m" : "",
                     "", width - filled);
}

}  // namespace

Progress::Progress(std::string what, long total) : Progress(std::move(what), total, StandardError()) {}

Progress::Progress(std::string what, long total, ProgressScreen screen)
    : what_(Printable(what)), total_(total), out_(std::move(screen)) {
  if (total_ <= 0) out_.stream = nullptr;
  if (out_.stream != nullptr && out_.screen.is_terminal) DrawBar("");
}

Progress::~Progress() {
  if (out_.stream == nullptr || !out_.screen.is_terminal) return;
  DrawBar(DurationText(Elapsed()));
  *out_.stream << '\n' << std::flush;
}

void Progress::Step() {
  ++done_;
  if (out_.stream == nullptr) return;
  if (out_.screen.is_terminal) {
    if (Clock::now() - drawn_ < kBetweenBars) return;
    remaining_.Add(done_, Elapsed());
    const std::optional<double> left = remaining_.Seconds(total_);
    DrawBar(left ? DurationText(*left) + " left" : "");
    return;
  }
  const long tenths = 10 * done_ / total_;
  if (tenths <= tenths_shown_) return;
  tenths_shown_ = tenths;
  *out_.stream << fmt::format("{} {}/{} ({} %)\n", what_, done_, total_, 10 * tenths) << std::flush;
}

double Progress::Elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

// One column stays free: terminals wrap a line that fills the last.
void Progress::DrawBar(const std::string& time) {
  const std::string count = fmt::format(" {}/{}{}{}", done_, total_, time.empty() ? "" : "  ", time);
  const long columns = std::max(out_.columns() - 1, 1);
  const long for_bar = columns - static_cast<long>(what_.size() + count.size());
  const std::string start = what_ + BarText(done_, total_, for_bar, out_.screen.colour);
  const std::string line =
      for_bar < 0 ? std::string(FirstBytes(what_ + count, static_cast<size_t>(columns))) : start + count;
  *out_.stream << '\r' << line << "\x1b[K" << std::flush;
  drawn_ = Clock::now();
}

}  // namespace armature
