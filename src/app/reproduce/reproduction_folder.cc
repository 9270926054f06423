// SPDX-License-Identifier: BSD-3-Clause
#include "app/reproduce/reproduction_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <stdexcept>

#include "io/errors.h"
#include "io/output_folder.h"
#include "io/run_folder.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

bool IsReproduction(const fs::path& folder) { return SaysComplete(folder / "environment.json"); }

void CheckReplaceable(const fs::path& folder) {
  if (!fs::exists(fs::symlink_status(folder))) return;
  if (fs::is_directory(folder) && (fs::is_empty(folder) || IsReproduction(folder))) return;
  throw InputError(
      fmt::format("{}: exists and was not made by 'armature reproduce'; choose another --name or --out",
                  folder.string()));
}

// So that two programs do not write into one folder.
int Lock(const fs::path& file, const fs::path& folder) {
  const int lock = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (lock < 0)
    throw InputError(
        fmt::format("{}: cannot be written to; choose another --out", file.parent_path().string()));
  if (flock(lock, LOCK_EX | LOCK_NB) == 0) return lock;
  close(lock);
  throw InputError(
      fmt::format("{}: another 'armature reproduce' is at work on it; wait for it, or choose another "
                  "--name",
                  folder.string()));
}

}  // namespace

ReproductionFolder::ReproductionFolder(const fs::path& root, const std::string& name) {
  std::error_code failure;
  fs::create_directories(root, failure);
  const fs::path absolute = fs::weakly_canonical(fs::absolute(root));
  folder_ = absolute / name;
  partial_ = absolute / (name + ".partial");
  latest_ = absolute / "latest";
  lock_file_ = absolute / (name + ".lock");
  CheckReplaceable(folder_);
  lock_ = Lock(lock_file_, folder_);
  fs::create_directories(partial_);
}

ReproductionFolder::~ReproductionFolder() {
  std::error_code ignored;
  fs::remove(lock_file_, ignored);
  close(lock_);
}

void ReproductionFolder::Publish() {
  CheckReplaceable(folder_);
  ReplaceFolder(partial_, folder_);
  const fs::path link = latest_.string() + ".partial";
  fs::remove(link);
  fs::create_directory_symlink(folder_.filename(), link);
  fs::rename(link, latest_);
}

}  // namespace armature
