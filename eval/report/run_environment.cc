// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/run_environment.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "io/json_fields.h"
#include "io/json_file.h"

namespace armature {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kRunRemedy = "run `armature run` again";

// ", modified" where the git state says so.
std::string CommitText(const Json& git) {
  return JsonField<std::string>(git, "commit") + (JsonFieldOr(git, "dirty", false) ? ", modified" : "");
}

// Runs of older programs may lack some of it.
EnvironmentEntries ReadEntries(const Json& summary) {
  EnvironmentEntries entries;
  if (summary.contains("version"))
    entries.emplace_back("armature", JsonField<std::string>(summary, "version"));
  if (summary.contains("git")) entries.emplace_back("commit", CommitText(JsonObject(summary, "git")));
  if (summary.contains("machine")) {
    const Json& machine = JsonObject(summary, "machine");
    entries.emplace_back("machine", fmt::format("{}, {} cores", JsonField<std::string>(machine, "cpu"),
                                                JsonField<int>(machine, "cores")));
  }
  if (!summary.contains("versions")) return entries;
  for (const auto& [name, version] : JsonObject(summary, "versions").items())
    entries.emplace_back(name, JsonAs<std::string>(version, Quoted("versions." + name)));
  return entries;
}

}  // namespace

EnvironmentEntries RunEnvironment(const std::filesystem::path& run) {
  const std::filesystem::path file = run / "summary.json";
  const Json summary = ReadJsonObject(file, kRunRemedy);
  try {
    return ReadEntries(summary);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}; {}", file.string(), error.what(), kRunRemedy));
  }
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
