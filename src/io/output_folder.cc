// SPDX-License-Identifier: BSD-3-Clause
#include "io/output_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>  // NOLINT: renameat2 is Linux
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>

#include "base/errors.h"
#include "base/write_failure.h"
#include "io/atomic_write.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

constexpr int kMostPartials = 100;  // more programs than write one folder at once

// Links and a trailing '/' resolved, so that the folder itself can be renamed.
fs::path Resolved(const fs::path& folder) {
  if (folder.empty()) throw InputError("the output folder has no name; name one with --out");
  fs::path resolved = fs::weakly_canonical(fs::absolute(folder)).lexically_normal();
  if (!resolved.has_filename()) resolved = resolved.parent_path();
  if (!resolved.has_filename())
    throw InputError(fmt::format("{}: is no folder to write to", folder.string()));
  return resolved;
}

// A partial folder is locked as long as its program lives.
FileDescriptor Lock(const fs::path& folder) {
  FileDescriptor opened(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW));
  if (opened.number() < 0 || flock(opened.number(), LOCK_EX | LOCK_NB) != 0) return FileDescriptor(-1);
  return opened;
}

fs::path PartialName(const fs::path& folder, int number) {
  fs::path partial = folder;
  return partial += fmt::format(".partial-{}", number);
}

// Those of programs that were killed. They may be whole: an older result, after the exchange.
void RemoveLeftovers(const fs::path& folder) {
  for (int number = 0; number < kMostPartials; ++number) {
    const fs::path partial = PartialName(folder, number);
    const FileDescriptor lock = Lock(partial);
    std::error_code ignored;
    if (lock.number() >= 0) fs::remove_all(partial, ignored);
  }
}

// Another program may take a new folder for a leftover until it is locked.
FileDescriptor CreatePartial(const fs::path& folder, fs::path& partial) {
  for (int number = 0; number < kMostPartials; ++number) {
    partial = PartialName(folder, number);
    if (!fs::create_directory(partial)) continue;  // another program has it
    FileDescriptor lock = Lock(partial);
    if (lock.number() >= 0 && fs::exists(partial)) return lock;
  }
  throw InputError(
      fmt::format("{}: {} programs are writing it; wait for them", folder.string(), kMostPartials));
}

// All that was written into it is on the disk, in one call however many files it has.
void Sync(const FileDescriptor& folder, const fs::path& name) {
  if (syncfs(folder.number()) != 0) throw InputError(WriteFailure(name, errno));
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

bool IsPartial(const fs::path& folder) {
  const std::string ending = folder.extension().string();
  if (ending == ".partial") return true;
  const std::string start = ".partial-";
  return ending.starts_with(start) && ending.size() > start.size() && std::isdigit(ending[start.size()]) != 0;
}

OutputFolder::OutputFolder(const fs::path& folder, Replaceable replaceable)
    : replaceable_(std::move(replaceable)) {
  try {
    folder_ = Resolved(folder);
    CheckReplaceable(folder_, replaceable_);
    fs::create_directories(folder_.parent_path());
    RemoveLeftovers(folder_);
    lock_ = CreatePartial(folder_, partial_);
  } catch (const fs::filesystem_error& error) {
    throw InputError(WriteFailure(folder, error.code().value()));
  }
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!partial_.empty()) fs::remove_all(partial_, ignored);
}

void OutputFolder::TakeOver() const {
  constexpr auto kByName = fs::copy_options::recursive | fs::copy_options::copy_symlinks;
  std::error_code failure;
  fs::copy(folder_, partial_, kByName | fs::copy_options::create_hard_links, failure);
  if (!failure) return;
  fs::copy(folder_, partial_, kByName | fs::copy_options::overwrite_existing,
           failure);  // no links on this disk
  if (failure) throw InputError(WriteFailure(folder_, failure.value()));
}

void OutputFolder::Publish() {
  CheckReplaceable(folder_, replaceable_);
  Sync(lock_, folder_);
  try {
    ReplaceFolder(partial_, folder_);
  } catch (const fs::filesystem_error& error) {
    throw InputError(WriteFailure(folder_, error.code().value()));
  }
  partial_.clear();
  lock_ = FileDescriptor(-1);
  SyncFolder(folder_.parent_path());
}

}  // namespace armature
