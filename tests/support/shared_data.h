// SPDX-License-Identifier: BSD-3-Clause
// Real data that stands beside the project and is not part of it. Tests that use it are skipped where it is
// absent.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace armature::testing {

// Where the data is: the environment's ARMATURE_SHARED, or `shared` beside the source folder.
inline std::filesystem::path SharedData(const std::string& path) {
  const char* folder = std::getenv("ARMATURE_SHARED");
  const std::filesystem::path root = folder != nullptr
                                         ? std::filesystem::path(folder)
                                         : std::filesystem::path(ARMATURE_SOURCE_DIR) / ".." / "shared";
  return root / "data" / path;
}

}  // namespace armature::testing

// Sets `variable` to the path of the shared data, or skips the test with a message.
#define ARMATURE_SHARED_DATA_OR_SKIP(variable, relative_path)                            \
  const std::filesystem::path variable = ::armature::testing::SharedData(relative_path); \
  if (!std::filesystem::exists(variable))                                                \
  GTEST_SKIP() << "needs the shared data '" << (relative_path) << "': set ARMATURE_SHARED to its folder"
