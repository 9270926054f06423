// SPDX-License-Identifier: BSD-3-Clause
// The CAD models nearest to every object of a finished run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/instance_libraries.h"
#include "mapping/solve_map.h"

namespace armature {

struct ObjectInstances {
  size_t object = 0;                           // of the map
  const CategoryInstances* library = nullptr;  // null: the library has none of the object's category
  std::vector<RetrievedInstance> instances;    // best first
};

struct RunRetrieval {
  std::filesystem::path run;
  std::string sequence;  // its name
  Map map;
  std::vector<ObjectInstances> objects;  // one an object of the map, in its order
};

// Reads the run and, for re-ranking, the images of its sequence (`sequence`: its folder, empty: where the run
// says). Throws InputError as run_map.h.
RunRetrieval RetrieveRun(const std::filesystem::path& run, const std::filesystem::path& sequence,
                         const std::vector<CategoryModel>& models, const OpenLibrary& library,
                         const RetrievalOptions& options);

}  // namespace armature
