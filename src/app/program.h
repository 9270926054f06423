// SPDX-License-Identifier: BSD-3-Clause
// The whole program but its start.
#pragma once

namespace armature {

// Runs the command of the arguments. The exit status: 0 done, 1 ran and failed, 2 bad usage or bad input, 130
// 143 and 129 interrupted, 141 nobody reads standard output any more.
int RunArmature(int argc, char** argv);

}  // namespace armature
