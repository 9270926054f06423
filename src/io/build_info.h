// SPDX-License-Identifier: BSD-3-Clause
// What this program was built from, and what it runs on.
#pragma once

#include <string>

namespace armature {

struct BuildInfo {
  std::string version;     // of Armature
  std::string git_commit;  // 12 digits, or "unknown"
  bool git_dirty = false;  // files differed from the commit
  std::string compiler;
  std::string flags;                 // build type and the compiler's flags
  std::string opencv, eigen, ceres;  // versions
};

BuildInfo GetBuildInfo();

struct MachineInfo {
  std::string cpu;  // as the system names it, or "unknown"
  int cores = 0;    // that threads can run on
};

MachineInfo GetMachineInfo();

// The most memory that this process has had resident so far, megabytes.
double PeakMemoryMegabytes();

}  // namespace armature
