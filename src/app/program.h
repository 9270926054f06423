// SPDX-License-Identifier: BSD-3-Clause
// The whole program but its start.
#pragma once

namespace armature {

// Runs the command of the arguments. The exit status: 0 done, 1 ran and failed, 2 bad usage or bad input, 130
// and 143 interrupted.
int RunArmature(int argc, char** argv);

}  // namespace armature
