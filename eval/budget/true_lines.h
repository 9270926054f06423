// SPDX-License-Identifier: BSD-3-Clause
// Lines as if each were an edge of a true object.
#pragma once

#include <filesystem>

#include "eval/budget/substituted_truth.h"

namespace armature {

// segments.csv with the visible edges of edges_gt.csv, and no other lines: each as long as what is seen of
// it, about its middle, for where it is hidden is not known. Throws InputError: a malformed or missing file,
// a row without image.
SubstitutedFiles ReplaceLines(const std::filesystem::path& sequence);

}  // namespace armature
