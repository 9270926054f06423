// SPDX-License-Identifier: BSD-3-Clause
#include "bench/engines.h"

#include <algorithm>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "bench/keypoints/keypoints_engine.h"
#include "bench/lines_engine.h"

namespace armature {
namespace {

const std::string kLines = "lines:";
const std::string kKeypoints = "keypoints:";

const std::map<std::string, KeypointsMode> kKeypointsModes{{"published", KeypointsMode::kPublished},
                                                           {"wait", KeypointsMode::kWait},
                                                           {"hourglass", KeypointsMode::kHourglass}};
std::unique_ptr<Engine> MakeBaseline(const std::string& mode, const EngineParts& parts) {
  return MakeKeypointsEngine(kKeypointsModes.at(mode), parts.options, parts.models);
}

}  // namespace

std::vector<std::string> EngineNames(const EngineParts& parts) {
  std::vector<std::string> names{kDefaultEngine};
  for (const auto& [preset, options] : parts.presets) {
    if (kLines + preset != kDefaultEngine) names.push_back(kLines + preset);
  }
  for (const auto& [mode, value] : kKeypointsModes) names.push_back(kKeypoints + mode);
  return names;
}

std::vector<std::string> DefaultEngines() {
  std::vector<std::string> names{kDefaultEngine};
  for (const auto& [mode, value] : kKeypointsModes) names.push_back(kKeypoints + mode);
  return names;
}

std::string FullEngineName(const std::string& name, const EngineParts& parts) {
  if (name == "lines") return kDefaultEngine;
  const std::vector<std::string> known = EngineNames(parts);
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw InputError("--engines: " + UnknownNameMessage("engine", name, known));
  return name;
}

bool IsLinesEngine(const std::string& full_name) { return full_name.starts_with(kLines); }

const Options& MakeOptions(const std::string& full_name, const EngineParts& parts) {
  return full_name == kDefaultEngine ? parts.options : parts.presets.at(full_name.substr(kLines.size()));
}

std::unique_ptr<Engine> MakeEngine(const std::string& full_name, const EngineParts& parts) {
  if (!IsLinesEngine(full_name)) return MakeBaseline(full_name.substr(kKeypoints.size()), parts);
  return std::make_unique<LinesEngine>(MakeOptions(full_name, parts), parts.models);
}

}  // namespace armature
