// SPDX-License-Identifier: BSD-3-Clause
#include "app/interrupt.h"

#include <csignal>

namespace armature {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void Note(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void CatchInterrupts() {
  std::signal(SIGINT, Note);
  std::signal(SIGTERM, Note);
}

void ThrowIfInterrupted() {
  if (interrupted != 0) throw Interrupted();
}

}  // namespace armature
