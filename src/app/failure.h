// SPDX-License-Identifier: BSD-3-Clause
// Whatever ends a command, as one line and an exit status.
#pragma once

#include <exception>
#include <string>

namespace armature {

struct Failure {
  std::string line;
  int status = 1;  // 1: ran and failed; 2: bad usage or bad input
};

// Of InputError, of the standard library and of the libraries that are used: none of their exceptions gets
// past this. `exception` is not null.
Failure DescribeFailure(const std::exception_ptr& exception);

}  // namespace armature
