// SPDX-License-Identifier: BSD-3-Clause
// rgb.txt: `timestamp filename` a line.
#include <fmt/format.h>

#include "base/errors.h"
#include "base/text.h"
#include "io/sequence.h"

namespace armature {
namespace {

ImageEntry ParseEntry(const TextLine& line, const std::filesystem::path& folder, const std::string& where) {
  const size_t blank = line.text.find_first_of(" \t");
  if (blank == std::string::npos) {
    throw InputError(fmt::format("{}: {} is not 'timestamp filename'; write both", where, Quoted(line.text)));
  }
  ImageEntry entry;
  entry.timestamp = ParseNumber(line.text.substr(0, blank), where);
  entry.file = folder / Trimmed(line.text.substr(blank));
  entry.line = line.number;
  return entry;
}

void CheckExists(const ImageEntry& entry, const std::string& where) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(entry.file, ignored)) return;
  throw InputError(fmt::format("{}: image {} does not exist; add the file or remove the line", where,
                               Quoted(entry.file.string())));
}

}  // namespace

std::vector<ImageEntry> ReadImageList(const std::filesystem::path& file) {
  std::vector<ImageEntry> images;
  for (const TextLine& line : ReadTextLines(file)) {
    const std::string where = fmt::format("{}:{}", file.string(), line.number);
    const ImageEntry entry = ParseEntry(line, file.parent_path(), where);
    CheckExists(entry, where);
    if (!images.empty() && entry.timestamp - images.back().timestamp <= kStampTolerance) {
      throw InputError(
          fmt::format("{}: stamp {:.6f} does not follow {:.6f} of line {} by more than 1 ms; sort the "
                      "images, one a stamp",
                      where, entry.timestamp, images.back().timestamp, images.back().line));
    }
    images.push_back(entry);
  }
  if (images.empty()) {
    throw InputError(fmt::format("{}: lists no image; write lines 'timestamp filename'", file.string()));
  }
  return images;
}

}  // namespace armature
