// SPDX-License-Identifier: BSD-3-Clause
// The one exception of bad input. Programs print what() and exit with status 2.
#pragma once

#include <stdexcept>
#include <string>

namespace armature {

// Bad usage or bad input: one line that names the file, the line where there is one, and the remedy.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace armature
