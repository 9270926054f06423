// SPDX-License-Identifier: BSD-3-Clause
// A library of instances as one binary file: a header (version, categories, their models' checksums, sizes),
// the numbers as they are in memory, names, and a checksum of all of it. Little-endian; a million chairs are
// read in about a second.
#pragma once

#include <filesystem>
#include <vector>

#include "category/category_model.h"
#include "retrieval/instance_library.h"

namespace armature {

// Written aside and renamed. Its root is stored relative to the file's folder where it can be. Throws
// InputError when it cannot be written.
void WriteLibrary(const InstanceLibrary& library, const std::filesystem::path& file);

// Throws InputError naming the file and the remedy: missing, not a library, of another version, cut short,
// corrupt, or coefficients that are not of these models (a category that there is no model of is no error: it
// is left out).
InstanceLibrary ReadLibrary(const std::filesystem::path& file, const std::vector<CategoryModel>& models);

}  // namespace armature
