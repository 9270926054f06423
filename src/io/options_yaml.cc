// SPDX-License-Identifier: BSD-3-Clause
#include "io/options_yaml.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "io/option_value.h"
#include "io/yaml_support.h"

namespace armature {
namespace {

const OptionEntry* Find(const std::vector<OptionEntry>& entries, const std::string& key) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const OptionEntry& entry) { return entry.key == key; });
  return found == entries.end() ? nullptr : &*found;
}

bool IsGroup(const std::vector<OptionEntry>& entries, const std::string& key) {
  return std::any_of(entries.begin(), entries.end(),
                     [&](const OptionEntry& entry) { return entry.key.starts_with(key + "."); });
}

[[noreturn]] void ThrowUnknown(const std::vector<OptionEntry>& entries, const std::string& key,
                               const std::string& where) {
  std::vector<std::string> known;
  known.reserve(entries.size());
  for (const OptionEntry& entry : entries) known.push_back(entry.key);
  throw InputError(fmt::format("{}: {}", where, UnknownNameMessage("option", key, known)));
}

void ApplyMap(const YamlMap& map, const std::string& prefix, const std::vector<OptionEntry>& entries) {
  for (const std::string& key : map.Keys()) {
    const std::string full_key = prefix + key;
    if (const OptionEntry* entry = Find(entries, full_key)) {
      SetOption(*entry, map.Text(key), map.Where(key));
    } else if (IsGroup(entries, full_key)) {
      ApplyMap(map.Map(key), full_key + ".", entries);
    } else {
      ThrowUnknown(entries, full_key, map.Where(key));
    }
  }
}

// The options below the prefix, each group where its first option stands in the table.
void WriteGroup(const std::vector<OptionEntry>& entries, const std::string& prefix, std::string* yaml) {
  const auto depth = 2 * std::count(prefix.begin(), prefix.end(), '.');
  std::set<std::string> written;
  for (const OptionEntry& entry : entries) {
    if (!entry.key.starts_with(prefix)) continue;
    const std::string rest = entry.key.substr(prefix.size());
    const std::string name = rest.substr(0, rest.find('.'));
    if (!written.insert(name).second) continue;
    if (name == rest) {
      *yaml += fmt::format("{:{}}{}: {}\n", "", depth, name, OptionText(entry));
    } else {
      *yaml += fmt::format("{:{}}{}:\n", "", depth, name);
      WriteGroup(entries, prefix + name + ".", yaml);
    }
  }
}

}  // namespace

void ApplyYaml(const std::filesystem::path& file, const std::vector<OptionEntry>& entries) {
  ApplyMap(YamlMap::Load(file), "", entries);
}

void ApplySetting(const std::string& setting, const std::vector<OptionEntry>& entries) {
  const std::string where = "--set " + Quoted(setting);
  const size_t equals = setting.find('=');
  if (equals == std::string::npos) throw InputError(where + ": has no '='; write --set key=value");
  const std::string key = Trimmed(setting.substr(0, equals));
  const OptionEntry* entry = Find(entries, key);
  if (entry == nullptr) ThrowUnknown(entries, key, where);
  SetOption(*entry, Trimmed(setting.substr(equals + 1)), where);
}

void CheckOptions(const std::vector<OptionEntry>& entries) {
  for (const OptionEntry& entry : entries) CheckOption(entry, "options");
}

std::string EffectiveYaml(const std::vector<OptionEntry>& entries) {
  std::string yaml;
  WriteGroup(entries, "", &yaml);
  return yaml;
}

}  // namespace armature
