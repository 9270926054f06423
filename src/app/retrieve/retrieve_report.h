// SPDX-License-Identifier: BSD-3-Clause
// What `armature retrieve` prints.
#pragma once

#include <vector>

#include "app/retrieve/retrieve_run.h"
#include "io/text_table.h"

namespace armature {

// A row an object: its nearest instances with their distances, or what their edges leave unexplained.
Table RetrievalTable(const std::vector<RunRetrieval>& runs, const RetrievalOptions& options);

// A row a category.
Table LibraryTable(const InstanceLibrary& library);

}  // namespace armature
