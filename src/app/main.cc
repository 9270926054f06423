// SPDX-License-Identifier: BSD-3-Clause
#include <malloc.h>

#include "app/program.h"

namespace {

// Pictures of megabytes come and go. Given back to the system each time, their pages have to be cleared
// again, which is a tenth of the time that rendering takes.
void KeepFreedMemory() {
  constexpr int kMostForMmap = 1 << 25, kNever = 1 << 30;  // bytes; the first is the most that glibc allows
  mallopt(M_MMAP_THRESHOLD, kMostForMmap);
  mallopt(M_TRIM_THRESHOLD, kNever);
}

}  // namespace

int main(int argc, char** argv) {
  KeepFreedMemory();
  return armature::RunArmature(argc, argv);
}
