// SPDX-License-Identifier: BSD-3-Clause
// Files that are there whole or as they were before.
#pragma once

#include <filesystem>
#include <string_view>

namespace armature {

// Writes the bytes aside and renames; creates the folders around the file. Throws InputError when it cannot
// be written.
void AtomicWrite(const std::filesystem::path& file, std::string_view bytes);

}  // namespace armature
