// SPDX-License-Identifier: BSD-3-Clause
// What `armature retrieve` leaves in a run's folder.
#pragma once

#include <filesystem>

#include "app/retrieve/retrieve_run.h"

namespace armature {

// retrieval.csv, a row an object and instance, and the run's objects.csv with the nearest instance's name.
// Each file is replaced whole.
void WriteRetrieval(const RunRetrieval& retrieval, const std::filesystem::path& folder);

}  // namespace armature
