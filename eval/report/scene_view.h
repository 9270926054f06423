// SPDX-License-Identifier: BSD-3-Clause
// A map to be turned with the mouse.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/report/report_data.h"
#include "eval/report/sequence_runs.h"

namespace armature {

// Of the first run, in the true world where there is a truth; true objects that the map misses are there with
// their box alone. None: the run has no map. `remarks`: surfaces that are left out. Throws InputError: a
// malformed file.
std::optional<SceneView> MakeSceneView(const SequenceRuns& sequence, const std::vector<CategoryModel>& models,
                                       const InstanceLibrary& library, std::vector<std::string>& remarks);

}  // namespace armature
