// SPDX-License-Identifier: BSD-3-Clause
// What a PLY file says before its data.
#pragma once

#include <filesystem>

namespace armature {

// Whether the file may be handed to PCL, which allocates whatever its header claims. Throws InputError naming
// the file: it cannot be read, does not start as PLY does, its header does not end or claims more elements
// than the file has bytes, has no vertices with float or double x, y and z or no faces, or belongs to a range
// image.
void CheckPlyHeader(const std::filesystem::path& file);

}  // namespace armature
