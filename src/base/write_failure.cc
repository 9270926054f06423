// SPDX-License-Identifier: BSD-3-Clause
#include "base/write_failure.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

namespace armature {
namespace {

const char* Remedy(int error) {
  switch (error) {
    case 0:
      return "is the disk full?";
    case ENOSPC:
      return "free some space on that disk, or choose a folder on another one";
    case EDQUOT:
      return "remove files of yours from that disk, or choose a folder on another one";
    case EFBIG:
      return "raise the limit of the size of files (ulimit -f)";
    case EROFS:
      return "choose a folder on a disk that is not read-only";
    case EACCES:
    case EPERM:
      return "choose a folder that may be written";
    case ENAMETOOLONG:
      return "choose a shorter name";
    case EISDIR:
      return "name a file, not a folder";
    case ENOTDIR:
    case EEXIST:
      return "a part of its path is a file; choose another folder";
    case ELOOP:
      return "its link leads back to itself; remove the link";
    case EMFILE:
    case ENFILE:
      return "raise the limit of open files (ulimit -n)";
    case EIO:
      return "the disk is damaged; choose another one";
    case EPIPE:
      return "what reads it has ended";
    default:
      return "choose another place";
  }
}

}  // namespace

std::string WriteFailure(const std::filesystem::path& file, int error) {
  const std::string reason = error == 0 ? "" : fmt::format(" ({})", std::strerror(error));
  return fmt::format("{}: cannot be written{}; {}", file.string(), reason, Remedy(error));
}

}  // namespace armature
