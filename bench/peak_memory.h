// SPDX-License-Identifier: BSD-3-Clause
// How much memory a piece of work needs, measured in a process of its own, for the peak of a process never
// falls again.
//
// On Linux a forked child begins with the pages that its parent has resident at that moment, not with the
// parent's peak, and its own peak counts from there (resetting it through /proc/self/clear_refs changes
// nothing). So the child's peak is that of the program, of what the parent has loaded and still holds, and of
// the work; free what is not needed before. What the parent has freed is given back to the system first.
#pragma once

#include <functional>

namespace armature {

struct PeakMemory {
  double before_mb = 0;  // megabytes (2^20), resident when the work began
  double peak_mb = 0;    // resident at most

  double added_mb() const { return peak_mb - before_mb; }
};

// Runs the work in a forked child, whose output is thrown away, and waits for it. Call it before any thread
// is started: a child has only the thread that forked, and locks that others held stay locked. Throws
// InputError with the child's message when the work threw one, std::runtime_error when it failed otherwise.
PeakMemory MeasurePeakMemory(const std::function<void()>& work);

}  // namespace armature
