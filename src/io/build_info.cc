// SPDX-License-Identifier: BSD-3-Clause
// The only file that includes git_state.h: it is compiled again after every commit.
#include "io/build_info.h"

#include <ceres/version.h>
#include <fmt/format.h>

#include <Eigen/Core>
#include <opencv2/core/version.hpp>

#include "git_state.h"

namespace armature {
namespace {

#if defined(__clang__)
constexpr const char* kCompiler = "Clang " __clang_version__;
#else
constexpr const char* kCompiler = "GCC " __VERSION__;
#endif

}  // namespace

BuildInfo GetBuildInfo() {
  return {.version = ARMATURE_VERSION,
          .git_commit = ARMATURE_GIT_COMMIT,
          .git_dirty = ARMATURE_GIT_DIRTY,
          .compiler = kCompiler,
          .flags = ARMATURE_CXX_FLAGS,
          .opencv = CV_VERSION,
          .eigen = fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION),
          .ceres = CERES_VERSION_STRING};
}

}  // namespace armature
