// SPDX-License-Identifier: BSD-3-Clause
// How well a category model describes objects it was not learnt from.
#pragma once

#include <vector>

#include "category/category_model.h"
#include "category/training_spec.h"

namespace armature {

struct ReconstructionError {
  double midpoint = 0;   // metres, mean over edges and models of |M - M'|
  double direction = 0;  // radians, mean over edges and models of the angle between D and D'
  int models = 0;
};

// Error of the model's nearest shapes to the wireframes (orthogonal projection), with its first `modes` modes
// only.
ReconstructionError Reconstruct(const CategoryModel& model, const std::vector<Wireframe>& wireframes,
                                int modes);

struct HeldOutRow {
  int modes = 0;
  int training_models = 0;
  ReconstructionError error;
};

// Leaves out every `every`-th wireframe (the last of each run of `every`), learns from the others and
// reconstructs those left out, once for each number of modes (rising). Where the others span fewer modes the
// last row has that many. Throws InputError for `every` < 2 or when too few wireframes remain.
std::vector<HeldOutRow> HeldOutErrors(const TrainingSpec& spec, const std::vector<Wireframe>& wireframes,
                                      int every, const std::vector<int>& modes);

}  // namespace armature
