// SPDX-License-Identifier: BSD-3-Clause
// Programs that are looked for in the wrong place.
#pragma once

#include <cstdlib>
#include <string>

namespace armature::testing {

// Programs are looked for in that folder alone while it lives.
class PathOverride {
 public:
  explicit PathOverride(const std::string& path) : before_(std::getenv("PATH")) {
    setenv("PATH", path.c_str(), 1);
  }
  ~PathOverride() { setenv("PATH", before_.c_str(), 1); }
  PathOverride(const PathOverride&) = delete;
  PathOverride& operator=(const PathOverride&) = delete;

 private:
  std::string before_;
};

}  // namespace armature::testing
