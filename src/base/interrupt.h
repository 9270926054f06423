// SPDX-License-Identifier: BSD-3-Clause
// Stopping with Ctrl-C without leaving half-written files behind: long work looks now and then, several times
// a second, whether it is to end, and what was written aside goes with the exception.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace armature {

// The user stopped the program; programs exit with SignalExitStatus(InterruptSignal()).
class Interrupted : public std::runtime_error {
 public:
  // `finished`: what stays of this call, files or folders, by name.
  explicit Interrupted(const std::vector<std::string>& finished = {});
};

// From now on the first SIGINT, SIGTERM or SIGHUP (the terminal is gone; not under nohup) is noted, the
// second ends the program at once. What no reader takes or no file may hold (SIGPIPE, SIGXFSZ) is an error of
// that output, and does not end the program amid others.
void CatchInterrupts();

// The signal that was noted, 0 before.
int InterruptSignal();

// 130 of SIGINT, 143 of SIGTERM, 129 of SIGHUP: what shells make of a program that a signal ends.
int SignalExitStatus(int signal);

// Throws Interrupted once a signal was noted.
void ThrowIfInterrupted();

// Calls the work and, if it is interrupted, says what was finished before it.
template <typename Work>
auto InterruptedAfter(const std::vector<std::string>& finished, const Work& work) {
  try {
    return work();
  } catch (const Interrupted&) {
    throw Interrupted(finished);
  }
}

}  // namespace armature
