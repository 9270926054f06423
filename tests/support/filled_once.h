// SPDX-License-Identifier: BSD-3-Clause
// A folder that is costly to fill, shared by the tests of a fixture.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "support/temp_folder.h"

namespace armature::testing {

// Filled when it is first asked for; each test gets it at the same path and as it was then, whatever the
// tests before did to it.
class FilledOnce {
 public:
  explicit FilledOnce(std::function<void(const TempFolder&)> fill) : fill_(std::move(fill)) {}

  const TempFolder& Restore() {
    if (kept_) {
      Replace(kept_->path(), folder_.path());
    } else {
      fill_(folder_);
      kept_.emplace();
      Replace(folder_.path(), kept_->path());
    }
    return folder_;
  }

 private:
  static void Replace(const std::filesystem::path& from, const std::filesystem::path& to) {
    for (const auto& entry : std::filesystem::directory_iterator(to)) {
      std::filesystem::remove_all(entry.path());
    }
    std::filesystem::copy(from, to, std::filesystem::copy_options::recursive);
  }

  std::function<void(const TempFolder&)> fill_;
  TempFolder folder_;
  std::optional<TempFolder> kept_;
};

}  // namespace armature::testing
