// SPDX-License-Identifier: BSD-3-Clause
// Engines by name: `family` or `family:variant`.
//   lines, lines:default   our pipeline with the options that the command was given
//   lines:PRESET           our pipeline with the options of that preset alone
//   keypoints:MODE         the keypoint-network baseline, see bench/keypoints/keypoints_engine.h
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bench/engine.h"
#include "category/category_model.h"
#include "pipeline/options.h"

namespace armature {

inline const std::string kDefaultEngine = "lines:default";

// What engines are made from.
struct EngineParts {
  Options options;                         // of lines:default
  std::map<std::string, Options> presets;  // of lines:PRESET, by name; "default" is not looked at
  std::vector<CategoryModel> models;
};

// All that can be made, lines:default first.
std::vector<std::string> EngineNames(const EngineParts& parts);

// Our pipeline and each mode of the baseline: what is compared when nothing is chosen.
std::vector<std::string> DefaultEngines();

// With the variant that is meant when there is none. Throws InputError for an unknown name.
std::string FullEngineName(const std::string& name, const EngineParts& parts);

bool IsLinesEngine(const std::string& full_name);

// Of a lines engine.
const Options& MakeOptions(const std::string& full_name, const EngineParts& parts);

// The full name has to be known.
std::unique_ptr<Engine> MakeEngine(const std::string& full_name, const EngineParts& parts);

}  // namespace armature
