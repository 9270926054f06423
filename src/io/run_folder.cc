// SPDX-License-Identifier: BSD-3-Clause
#include "io/run_folder.h"

#include <nlohmann/json.hpp>

#include "io/json_file.h"

namespace armature {

bool SaysComplete(const std::filesystem::path& file) {
  const std::optional<nlohmann::ordered_json> json = FindJsonObject(file);
  return json && json->contains("complete") && json->at("complete") == true;
}

bool IsCompleteRun(const std::filesystem::path& folder) { return SaysComplete(folder / "summary.json"); }

}  // namespace armature
