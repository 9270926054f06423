// SPDX-License-Identifier: BSD-3-Clause
#include "app/reproduce/job_key.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "base/checksum.h"
#include "base/errors.h"
#include "base/text.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

std::string FormatHex(const std::string& bytes) {
  return fmt::format("{:016x}", Checksum(std::as_bytes(std::span(bytes))));
}

std::vector<fs::path> FilesBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::recursive_directory_iterator(folder, fs::directory_options::follow_directory_symlink)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string ReadContent(const fs::path& path) {
  if (!fs::is_directory(path)) return FormatHex(ReadTextFile(path));
  std::string listing;
  for (const fs::path& file : FilesBelow(path))
    listing += fmt::format("{} {}\n", file.lexically_relative(path).string(), FormatHex(ReadTextFile(file)));
  return FormatHex(listing);
}

}  // namespace

std::string ContentHashes::Of(const fs::path& path) {
  const auto [known, is_new] = known_.try_emplace(path);
  if (is_new) known->second = ReadContent(path);
  return known->second;
}

std::string MakeKey(const Job& job, const fs::path& folder, const fs::path& program, ContentHashes& hashes) {
  std::string text = hashes.Of(program) + "\n";
  for (const auto& command : job.commands) text += fmt::format("{}\n", fmt::join(command, "\n"));
  for (const fs::path& input : job.inputs)
    text += fmt::format("{} {}\n", input.string(), hashes.Of(folder / input));
  return FormatHex(text);
}

}  // namespace armature
