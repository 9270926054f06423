// SPDX-License-Identifier: BSD-3-Clause
#include "io/atomic_write.h"

#include <fmt/format.h>

#include <fstream>

#include "base/errors.h"

namespace armature {

void AtomicWrite(const std::filesystem::path& file, std::string_view bytes) {
  std::error_code error;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
  std::filesystem::path aside = file;
  aside += ".partial";
  std::ofstream stream(aside, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (stream) std::filesystem::rename(aside, file, error);
  if (stream && !error) return;
  std::error_code left;
  std::filesystem::remove(aside, left);
  throw InputError(fmt::format("{}: cannot be written; choose a folder that may be written", file.string()));
}

}  // namespace armature
