// SPDX-License-Identifier: BSD-3-Clause
// Files that are there whole or as they were before.
#pragma once

#include <filesystem>
#include <string_view>

namespace armature {

// Writes the bytes aside (FILE.partial), sees to it that they are on the disk, and renames; creates the
// folders around the file. A link stays one: what it leads to is written. What is no regular file
// (/dev/stdout, a FIFO, /dev/null) is written to. Throws InputError when it cannot be written, and for
// folders and disks.
void AtomicWrite(const std::filesystem::path& file, std::string_view bytes);

// A file of an OutputFolder, which is put in place when all its files are whole. Throws as AtomicWrite.
void WriteFile(const std::filesystem::path& file, std::string_view bytes);

// Where the file really is: behind links, also behind one that leads to nothing yet. Throws InputError for
// links in a circle.
std::filesystem::path BehindLinks(const std::filesystem::path& file);

// The names in the folder are on the disk: after a rename in it, which else may be lost with the power.
void SyncFolder(const std::filesystem::path& folder);

}  // namespace armature
