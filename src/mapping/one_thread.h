// SPDX-License-Identifier: BSD-3-Clause
// Solving on one thread, which Ceres' num_threads does not settle.
//
// CHOLMOD, which factorises Ceres' sparse normal equations, runs loops over rows of each supernode on four
// OpenMP threads of its own. The loops are so short that the threads mostly wait for each other: on two cores
// sphere2500 takes 1.2 to 2 times as long as with one thread.
#pragma once

namespace armature {

// While it lives, parallel regions that this thread enters run on it alone.
class OneThread {
 public:
  OneThread();
  ~OneThread();
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int max_active_levels_;  // of parallel regions, as it was
};

}  // namespace armature
