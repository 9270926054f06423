// SPDX-License-Identifier: BSD-3-Clause
// Stopping with Ctrl-C without leaving half-written folders behind.
#pragma once

#include <stdexcept>

namespace armature {

// The user stopped the program; programs exit with status 1.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted; nothing was written") {}
};

// From now on the first SIGINT or SIGTERM is noted, the second ends the program at once.
void CatchInterrupts();

// Throws Interrupted once a signal was noted.
void ThrowIfInterrupted();

}  // namespace armature
