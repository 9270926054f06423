// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/generation_stamp.h"

#include <fmt/format.h>

#include <cstdint>

#include "base/errors.h"
#include "base/text.h"
#include "io/atomic_write.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFile = "generated.json";

// FNV-1a, 64 bits.
std::uint64_t Hash(const std::string& text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return hash;
}

}  // namespace

std::string GenerationStamp(const std::string& what) {
  return fmt::format("{{\"generator\": {}, \"made_from\": \"{:016x}\"}}\n", kGeneratorVersion, Hash(what));
}

void WriteStamp(const fs::path& folder, const std::string& stamp) { WriteFile(folder / kFile, stamp); }

bool HasStamp(const fs::path& folder, const std::string& stamp) {
  try {
    return ReadTextFile(folder / kFile) == stamp;
  } catch (const InputError&) {  // none is there
    return false;
  }
}

Replaceable GeneratedFolders() {
  return {"made by `armature generate`",
          [](const fs::path& folder) { return fs::is_regular_file(folder / kFile); }};
}

}  // namespace armature
