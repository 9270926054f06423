// SPDX-License-Identifier: BSD-3-Clause
#include "bench/bench_arguments.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "base/text.h"
#include "io/json_fields.h"
#include "io/json_file.h"
#include "io/option_value.h"

namespace armature {
namespace {

using Json = nlohmann::ordered_json;

template <typename Value>
Json ToJson(const Value& value) {
  return value;
}

Json ToJson(const std::filesystem::path& path) { return path.string(); }

Json ToJson(const std::vector<std::filesystem::path>& paths) {
  Json json = Json::array();
  for (const auto& path : paths) json.push_back(path.string());
  return json;
}

template <typename Value>
void TakeField(const Json& json, const char* key, Value& value) {
  value = JsonField<Value>(json, key);
}

void TakeField(const Json& json, const char* key, std::filesystem::path& path) {
  path = JsonField<std::string>(json, key);
}

void TakeField(const Json& json, const char* key, std::vector<std::filesystem::path>& paths) {
  const auto texts = JsonField<std::vector<std::string>>(json, key);
  paths.assign(texts.begin(), texts.end());
}

// A reference that is older than a setting was measured with its default.
void TakeSetting(const Json& settings, const KeptArgument& kept, const std::filesystem::path& reference) {
  if (settings.is_object() && !settings.empty() && !settings.contains(kept.setting)) return;
  try {
    std::visit([&](auto* field) { TakeField(settings, kept.setting, *field); }, kept.field);
  } catch (const InputError&) {
    throw InputError(
        fmt::format("{}: its settings have no usable '{}'; give {} or write a new one with 'armature bench'",
                    reference.string(), kept.setting, kept.option));
  }
}

void CheckFolder(const std::filesystem::path& folder, const char* what, const BenchArguments& a) {
  if (std::filesystem::is_directory(folder)) return;
  throw InputError(
      fmt::format("{}: its folder {} is not here; make the generated ones with scripts/run.sh, or name "
                  "another with {}",
                  a.against.string(), Quoted(folder.string()), what));
}

}  // namespace

std::vector<KeptArgument> KeptArguments(BenchArguments& a) {
  return {{"SEQUENCE", "sequences", &a.sequences},
          {"--tables", "tables", &a.tables},
          {"--engines", "engines", &a.engines},
          {"--micro", "micro", &a.micro},
          {"--retrieval-sizes", "retrieval_sizes", &a.retrieval_sizes},
          {"--frames", "frames", &a.frames},
          {"--warm-up", "warm_up", &a.warm_up},
          {"--repeat", "repeat", &a.repeat},
          {"--threads", "threads", &a.threads},
          {"--objects", "objects", &a.objects},
          {"--baseline-frames", "baseline_frames", &a.baseline_frames},
          {"--cad", "cad", &a.cad},
          {"--preset", "preset", &a.configuration.preset},
          {"--config", "config", &a.configuration.config},
          {"--set", "set", &a.configuration.settings},
          {"--categories", "categories", &a.configuration.categories},
          {"--configs", "configs", &a.configuration.configs}};
}

Json SettingsJson(BenchArguments a, Options options) {
  Json json;
  for (const KeptArgument& kept : KeptArguments(a))
    json[kept.setting] = std::visit([](const auto* field) { return ToJson(*field); }, kept.field);
  for (const OptionEntry& entry : OptionTable(options)) json["options"][entry.key] = OptionText(entry);
  return json;
}

void TakeReferenceSettings(BenchArguments& a) {
  const Json reference = ReadJsonObject(a.against, "write a new one with 'armature bench'");
  const Json settings = reference.contains("settings") ? reference["settings"] : Json::object();
  for (const KeptArgument& kept : KeptArguments(a)) {
    if (!a.given.contains(kept.setting)) TakeSetting(settings, kept, a.against);
  }
  if (!a.given.contains("sequences")) {
    for (const auto& folder : a.sequences) CheckFolder(folder, "SEQUENCE", a);
  }
  const auto& categories = a.configuration.categories;
  if (!a.given.contains("categories") && !categories.empty()) CheckFolder(categories, "--categories", a);
}

}  // namespace armature
