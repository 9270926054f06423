// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/run_environment.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "eval/report/table_json.h"

namespace armature {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kRunRemedy = "run `armature run` again";

// Runs of older programs may lack some of it.
void AddMachineAndVersions(const Json& summary, EnvironmentEntries& entries) {
  if (summary.contains("git")) {
    entries.emplace_back("commit", summary["git"].at("commit").get<std::string>() +
                                       (summary["git"].value("dirty", false) ? ", modified" : ""));
  }
  if (summary.contains("machine")) {
    entries.emplace_back("machine",
                         fmt::format("{}, {} cores", summary["machine"].at("cpu").get<std::string>(),
                                     summary["machine"].at("cores").get<int>()));
  }
  if (!summary.contains("versions")) return;
  for (const auto& [name, version] : summary["versions"].items())
    entries.emplace_back(name, version.get<std::string>());
}

}  // namespace

EnvironmentEntries RunEnvironment(const std::filesystem::path& run) {
  const std::filesystem::path file = run / "summary.json";
  const Json summary = ReadJson(file, kRunRemedy);
  EnvironmentEntries entries;
  try {
    if (summary.contains("version")) entries.emplace_back("armature", summary["version"].get<std::string>());
    AddMachineAndVersions(summary, entries);
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("{}: is malformed ({}); {}", file.string(), error.what(), kRunRemedy));
  }
  return entries;
}

void MergeEnvironment(const EnvironmentEntries& more, EnvironmentEntries& all) {
  for (const auto& [name, value] : more) {
    const auto known =
        std::find_if(all.begin(), all.end(), [&key = name](const auto& e) { return e.first == key; });
    if (known == all.end()) {
      all.emplace_back(name, value);
    } else if (("; " + known->second + "; ").find("; " + value + "; ") == std::string::npos) {
      known->second += "; " + value;
    }
  }
}

}  // namespace armature
