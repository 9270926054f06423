// SPDX-License-Identifier: BSD-3-Clause
// Detections with the truth in them. Rows keep their order and, but for what is replaced, their text.
#pragma once

#include <filesystem>

#include "eval/budget/substituted_truth.h"
#include "truth/sequence_truth.h"

namespace armature {

// detections.csv and detections_gt.csv with the first detection of each true object in an image that has its
// category, and no others. Throws InputError: a malformed or missing file, a row without image.
SubstitutedFiles KeepTrueDetections(const std::filesystem::path& folder, const SequenceTruth& sequence);

// The same with the object's id in place of the category, and an objects_gt.csv to it. Throws also for an id
// that cannot name a category.
SubstitutedFiles NameDetectionsByObject(const std::filesystem::path& folder, const SequenceTruth& sequence);

// detections.csv with true viewpoints, seen along the ray through the middle of the box, of those that are of
// a true object of their category in an image with a true camera; others are as they were. Throws as the
// first.
SubstitutedFiles ReplaceViewpoints(const std::filesystem::path& folder, const SequenceTruth& sequence);

}  // namespace armature
