// SPDX-License-Identifier: BSD-3-Clause
#include "io/atomic_write.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <thread>

#include "base/child_process.h"
#include "base/errors.h"
#include "base/interrupt.h"
#include "base/write_failure.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as the kernel follows
constexpr std::chrono::milliseconds kBetweenLooksForReader{20};

// All its bytes or false, with errno.
bool WriteBytes(const FileDescriptor& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file.number(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  return true;
}

[[noreturn]] void Fail(const fs::path& file, int error) { throw InputError(WriteFailure(file, error)); }

void CreateFolders(const fs::path& file) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) Fail(file, error.value());
}

// A program that died left it unlocked; of two that write the same file, the second waits.
FileDescriptor OpenAside(const fs::path& aside, const fs::path& file) {
  while (true) {
    FileDescriptor opened(open(aside.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
    if (opened.number() < 0) Fail(file, errno);
    flock(opened.number(), LOCK_EX);
    struct stat held {
    }, named{};
    fstat(opened.number(), &held);
    const bool is_it = stat(aside.c_str(), &named) == 0 && held.st_ino == named.st_ino;
    if (!is_it) continue;  // the other has renamed it
    if (ftruncate(opened.number(), 0) != 0) Fail(file, errno);
    return opened;
  }
}

void Replace(const fs::path& file, std::string_view bytes) {
  CreateFolders(file);
  fs::path aside = file;
  aside += ".partial";
  const FileDescriptor opened = OpenAside(aside, file);
  if (WriteBytes(opened, bytes) && fsync(opened.number()) == 0 &&
      std::rename(aside.c_str(), file.c_str()) == 0) {
    return SyncFolder(file.parent_path());
  }
  const int error = errno;
  unlink(aside.c_str());
  Fail(file, error);
}

bool IsStandardOutput(const struct stat& file) {
  struct stat output {};
  return fstat(STDOUT_FILENO, &output) == 0 && output.st_dev == file.st_dev && output.st_ino == file.st_ino;
}

// A FIFO is opened once somebody reads it; until then the program can be interrupted.
FileDescriptor OpenStream(const fs::path& file) {
  while (true) {
    const int opened = open(file.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    if (opened < 0 && errno != ENXIO) Fail(file, errno);
    if (opened >= 0) {
      fcntl(opened, F_SETFL, O_WRONLY);
      return FileDescriptor(opened);
    }
    ThrowIfInterrupted();
    std::this_thread::sleep_for(kBetweenLooksForReader);
  }
}

void WriteThrough(const fs::path& file, const struct stat& status, std::string_view bytes) {
  if (!S_ISREG(status.st_mode) && !S_ISFIFO(status.st_mode) && !S_ISCHR(status.st_mode)) {
    throw InputError(fmt::format("{}: cannot be written: is {}; name a file", file.string(),
                                 S_ISDIR(status.st_mode) ? "a folder" : "no file"));
  }
  if (IsStandardOutput(status)) std::fflush(stdout);  // what was printed before comes before
  const FileDescriptor opened =
      IsStandardOutput(status) ? FileDescriptor(dup(STDOUT_FILENO)) : OpenStream(file);
  if (!WriteBytes(opened, bytes)) Fail(file, errno);
}

}  // namespace

fs::path BehindLinks(const fs::path& file) {
  fs::path target = file;
  std::error_code none;
  for (int links = 0; fs::is_symlink(fs::symlink_status(target, none)); ++links) {
    if (links == kMostLinks) Fail(file, ELOOP);
    target = target.parent_path() / fs::read_symlink(target);
  }
  return target;
}

void AtomicWrite(const fs::path& file, std::string_view bytes) {
  struct stat status {};
  const bool is_there = stat(file.c_str(), &status) == 0;
  if (is_there && (!S_ISREG(status.st_mode) || IsStandardOutput(status))) {
    return WriteThrough(file, status, bytes);
  }
  Replace(BehindLinks(file), bytes);
}

void WriteFile(const fs::path& file, std::string_view bytes) {
  CreateFolders(file);
  const FileDescriptor opened(open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (opened.number() < 0 || !WriteBytes(opened, bytes)) Fail(file, errno);
}

void SyncFolder(const fs::path& folder) {
  const fs::path named = folder.empty() ? fs::path(".") : folder;
  const FileDescriptor opened(open(named.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.number() >= 0) fsync(opened.number());  // file systems that cannot do it need not
}

}  // namespace armature
