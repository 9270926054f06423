// SPDX-License-Identifier: BSD-3-Clause
#include "cli/data_folders.h"

#include <cstdlib>

namespace armature {
namespace {

namespace fs = std::filesystem;

// `folder` as the source tree has it; scripts/cmake/install.cmake keeps these names.
fs::path DataFolder(const fs::path& folder) {
  std::error_code absent;
  const fs::path program = fs::read_symlink("/proc/self/exe", absent);
  const fs::path installed = program.parent_path().parent_path() / "share/armature" / folder;
  if (!absent && fs::is_directory(installed, absent)) return installed;
  return fs::path(ARMATURE_SOURCE_FOLDER) / folder;
}

}  // namespace

fs::path ConfigsFolder(const fs::path& named) {
  if (!named.empty()) return named;
  if (const char* folder = std::getenv("ARMATURE_CONFIGS"); folder != nullptr) return folder;
  return DataFolder("configs");
}

fs::path ScenesFolder() { return DataFolder("datasets/scenes"); }

fs::path ResultsFolder() { return DataFolder("results"); }

}  // namespace armature
