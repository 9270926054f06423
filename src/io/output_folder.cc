// SPDX-License-Identifier: BSD-3-Clause
#include "io/output_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>  // NOLINT: renameat2 is Linux

#include "base/errors.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

// Links and a trailing '/' resolved, so that the folder itself can be renamed.
fs::path Resolved(const fs::path& folder) {
  if (folder.empty()) throw InputError("the output folder has no name; name one with --out");
  fs::path resolved = fs::weakly_canonical(fs::absolute(folder)).lexically_normal();
  if (!resolved.has_filename()) resolved = resolved.parent_path();
  if (!resolved.has_filename())
    throw InputError(fmt::format("{}: is no folder to write to", folder.string()));
  return resolved;
}

fs::path CreatePartial(const fs::path& folder) {
  for (int number = 0;; ++number) {
    fs::path partial = folder;
    partial += fmt::format(".partial-{}", number);
    if (fs::create_directory(partial)) return partial;  // false: another program has it
  }
}

// Both folders exist and change places, at once where the file system can.
void Exchange(const fs::path& a, const fs::path& b) {
  if (renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0) return;
  fs::path aside = b;
  aside += "-old";
  fs::rename(b, aside);
  fs::rename(a, b);
  fs::rename(aside, a);
}

}  // namespace

void CheckReplaceable(const fs::path& folder, const Replaceable& replaceable) {
  if (!fs::exists(fs::symlink_status(folder))) return;
  if (fs::is_directory(folder) && (fs::is_empty(folder) || replaceable.is(folder))) return;
  throw InputError(fmt::format("{}: exists and is not {}; choose another folder or move it away",
                               folder.string(), replaceable.what));
}

void ReplaceFolder(const fs::path& from, const fs::path& to) {
  if (!fs::exists(to)) return fs::rename(from, to);
  Exchange(from, to);
  std::error_code ignored;
  fs::remove_all(from, ignored);  // now the older one
}

OutputFolder::OutputFolder(const fs::path& folder, Replaceable replaceable)
    : replaceable_(std::move(replaceable)) {
  try {
    folder_ = Resolved(folder);
    CheckReplaceable(folder_, replaceable_);
    fs::create_directories(folder_.parent_path());
    partial_ = CreatePartial(folder_);
  } catch (const fs::filesystem_error& error) {
    throw InputError(fmt::format("{}: cannot be created ({}); choose a folder that may be written",
                                 folder.string(), error.code().message()));
  }
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!partial_.empty()) fs::remove_all(partial_, ignored);
}

void OutputFolder::Publish() {
  CheckReplaceable(folder_, replaceable_);
  ReplaceFolder(partial_, folder_);
  partial_.clear();
}

}  // namespace armature
