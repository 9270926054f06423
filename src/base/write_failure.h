// SPDX-License-Identifier: BSD-3-Clause
// Why something cannot be written, and what its user can do about it.
#pragma once

#include <filesystem>
#include <string>

namespace armature {

// "FILE: cannot be written (No space left on device); free some space on that disk, or ...". `error`: errno;
// 0: not known.
std::string WriteFailure(const std::filesystem::path& file, int error);

}  // namespace armature
