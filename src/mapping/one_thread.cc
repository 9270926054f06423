// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/one_thread.h"

#include <omp.h>

namespace armature {

// Neither omp_set_num_threads nor OMP_NUM_THREADS has a say: CHOLMOD's regions ask for their number.
OneThread::OneThread() : max_active_levels_(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }

OneThread::~OneThread() { omp_set_max_active_levels(max_active_levels_); }

}  // namespace armature
