// SPDX-License-Identifier: BSD-3-Clause
// What `armature retrieve` leaves in a run's folder.
#pragma once

#include "app/retrieve/retrieve_run.h"

namespace armature {

// retrieval.csv in the run's folder, a row an object and instance, and the nearest instance's name in
// objects.csv. Each file is replaced whole.
void WriteRetrieval(const RunRetrieval& retrieval);

}  // namespace armature
