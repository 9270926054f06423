// SPDX-License-Identifier: BSD-3-Clause
#include "io/run_folder.h"

#include <fstream>
#include <nlohmann/json.hpp>

namespace armature {

bool SaysComplete(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) return false;
  const nlohmann::json json = nlohmann::json::parse(stream, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object() || !json.contains("complete")) return false;
  return json["complete"].is_boolean() && json["complete"].get<bool>();
}

bool IsCompleteRun(const std::filesystem::path& folder) { return SaysComplete(folder / "summary.json"); }

}  // namespace armature
