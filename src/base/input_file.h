// SPDX-License-Identifier: BSD-3-Clause
// The one door through which input files are read.
#pragma once

#include <filesystem>
#include <string>

namespace armature {

// The bytes of a regular file, or of a link to one. Throws InputError, at once, for anything else: a file
// that is missing or may not be read, a folder, a pipe, a socket, a device, a circle of links, more bytes
// than any reader has a use for.
std::string ReadInputFile(const std::filesystem::path& file);

}  // namespace armature
