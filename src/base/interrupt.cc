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
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
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
}

int InterruptSignal() { return noted_signal; }

int SignalExitStatus(int signal) { return 128 + signal; }

void ThrowIfInterrupted() {
  if (noted_signal != 0) throw Interrupted();
}

}  // namespace armature
