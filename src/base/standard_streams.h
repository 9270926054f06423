// SPDX-License-Identifier: BSD-3-Clause
// Standard input, output and error as the program was given them: closed, full, or read by nobody.
#pragma once

#include <string_view>

namespace armature {

// Opens those that are closed on /dev/null: the next file that is opened would else take their place, and
// what is printed would go into it.
void OpenStandardStreams();

// Prints what standard output still holds. Returns errno, 0 when all that was ever printed is out.
int FlushStandardOutput();

// What cannot be told is not told: a run does not fail because nobody listens.
void PrintToStandardError(std::string_view text);

}  // namespace armature
