// SPDX-License-Identifier: BSD-3-Clause
#include "app/reproduce/reproduction_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <stdexcept>

#include "base/errors.h"
#include "io/output_folder.h"
#include "io/run_folder.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

const Replaceable kReproductions{"a folder of results of 'armature reproduce'", [](const fs::path& folder) {
                                   return SaysComplete(folder / "environment.json");
                                 }};

// So that two programs do not write into one folder. Ends with the descriptor, also when the folder is
// renamed.
int Lock(const fs::path& folder) {
  const int lock = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock < 0) throw InputError(fmt::format("{}: cannot be opened; choose another --out", folder.string()));
  if (flock(lock, LOCK_EX | LOCK_NB) == 0) return lock;
  close(lock);
  throw InputError(
      fmt::format("{}: another 'armature reproduce' is at work in it; wait for it, or choose another --name",
                  folder.string()));
}

}  // namespace

ReproductionFolder::ReproductionFolder(const fs::path& root, const std::string& name) {
  const fs::path absolute = fs::weakly_canonical(fs::absolute(root));
  folder_ = absolute / name;
  partial_ = absolute / (name + ".partial");
  latest_ = absolute / "latest";
  CheckReplaceable(folder_, kReproductions);
  std::error_code failure;
  fs::create_directories(partial_, failure);
  if (failure) {
    throw InputError(fmt::format("{}: cannot be created ({}); choose another --out", partial_.string(),
                                 failure.message()));
  }
  lock_ = Lock(partial_);
}

ReproductionFolder::~ReproductionFolder() { close(lock_); }

void ReproductionFolder::Publish() {
  CheckReplaceable(folder_, kReproductions);
  ReplaceFolder(partial_, folder_);
  const fs::path link = latest_.string() + ".partial";
  fs::remove(link);
  fs::create_directory_symlink(folder_.filename(), link);
  fs::rename(link, latest_);
}

}  // namespace armature
