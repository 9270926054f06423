// SPDX-License-Identifier: BSD-3-Clause
#include "base/interrupt.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <csignal>

namespace armature {
namespace {

volatile std::sig_atomic_t noted_signal = 0;

void NoteSignal(int signal) {
  noted_signal = signal;
  for (const int ending : {SIGINT, SIGTERM, SIGHUP}) std::signal(ending, SIG_DFL);
}

std::string Message(const std::vector<std::string>& finished) {
  if (finished.empty()) return "interrupted; nothing was written";
  return fmt::format("interrupted; finished before: {}", fmt::join(finished, ", "));
}

}  // namespace

Interrupted::Interrupted(const std::vector<std::string>& finished) : std::runtime_error(Message(finished)) {}

void CatchInterrupts() {
  std::signal(SIGINT, NoteSignal);
  std::signal(SIGTERM, NoteSignal);
  if (std::signal(SIGHUP, NoteSignal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

int InterruptSignal() { return noted_signal; }

int SignalExitStatus(int signal) { return 128 + signal; }

void ThrowIfInterrupted() {
  if (noted_signal != 0) throw Interrupted();
}

}  // namespace armature
