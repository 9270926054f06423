// SPDX-License-Identifier: BSD-3-Clause
// Sequences with one thing replaced by the truth: input for runs that tell what the error of that thing
// costs. Their results say nothing about how well a method does.
#pragma once

#include <filesystem>
#include <vector>

#include "category/category_model.h"
#include "eval/budget/substituted_truth.h"

namespace armature {

// The files that take the place of the sequence's own. Throws InputError: a file that the truth is in is
// missing (which one, and which truth cannot be given) or malformed, a category without model.
SubstitutedFiles SubstituteTruth(const std::filesystem::path& sequence, SubstitutedTruth truth,
                                 const std::vector<CategoryModel>& models);

// Writes `folder`: the sequence with these files, all others linked (copied where links fail). Throws
// InputError when it cannot be written, or something is there that is no such folder.
void WriteSubstitution(const std::filesystem::path& sequence, SubstitutedTruth truth,
                       const SubstitutedFiles& files, const std::filesystem::path& folder);

// Throws InputError when `folder` may not be written for the sequence.
void CheckSubstitution(const std::filesystem::path& sequence, const std::filesystem::path& folder);

// The sequence that the folder was made from; itself where it is no substituted one. Links are resolved.
std::filesystem::path OriginOfSequence(const std::filesystem::path& folder);

// Those of a substituted sequence whose objects are categories of their own; else `models`.
std::vector<CategoryModel> ModelsOfSequence(const std::filesystem::path& folder,
                                            const std::vector<CategoryModel>& models);

}  // namespace armature
