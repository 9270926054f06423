// SPDX-License-Identifier: BSD-3-Clause
#include "io/run_folder.h"

#include <fstream>
#include <nlohmann/json.hpp>

namespace armature {

bool IsCompleteRun(const std::filesystem::path& folder) {
  std::ifstream stream(folder / "summary.json");
  if (!stream) return false;
  const nlohmann::json summary = nlohmann::json::parse(stream, nullptr, /*allow_exceptions=*/false);
  if (!summary.is_object() || !summary.contains("complete")) return false;
  return summary["complete"].is_boolean() && summary["complete"].get<bool>();
}

}  // namespace armature
