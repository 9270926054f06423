// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/scene/scene_fields.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "base/text.h"
#include "io/option_value.h"

namespace armature {
namespace {

std::vector<double> ReadList(const YamlMap& map, const std::string& key, size_t count,
                             const std::string& form) {
  std::vector<double> values = map.Numbers(key);
  if (values.size() == count) return values;
  throw InputError(map.At(key, fmt::format("has {} values; write the {} {}", values.size(), count, form)));
}

bool IsNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

}  // namespace

void ReadFields(const YamlMap& map, const std::vector<OptionEntry>& fields,
                const std::vector<std::string>& more_keys) {
  std::vector<std::string> known = more_keys;
  for (const OptionEntry& field : fields) known.push_back(field.key);
  map.CheckKeys(known);
  for (const OptionEntry& field : fields) ReadField(map, field);
}

void ReadField(const YamlMap& map, const OptionEntry& field) {
  if (map.Has(field.key)) SetOption(field, map.Text(field.key), map.Where(field.key));
}

Eigen::Vector2d ReadPair(const YamlMap& map, const std::string& key) {
  const std::vector<double> values = ReadList(map, key, 2, "[x, y]");
  return {values[0], values[1]};
}

Eigen::Vector3d ReadTriple(const YamlMap& map, const std::string& key) {
  const std::vector<double> values = ReadList(map, key, 3, "[x, y, z]");
  return {values[0], values[1], values[2]};
}

Eigen::Vector3d ReadSize(const YamlMap& map, const std::string& key) {
  Eigen::Vector3d size = ReadTriple(map, key);
  if (size.minCoeff() > 0) return size;
  throw InputError(map.At(key, fmt::format("is [{}, {}, {}]; write lengths greater than 0, in metres",
                                           size[0], size[1], size[2])));
}

Colour ReadColour(const YamlMap& map, const std::string& key) {
  const std::vector<double> values = ReadList(map, key, 3, "[red, green, blue], each 0..1");
  Colour colour(values[0], values[1], values[2]);
  if (colour.minCoeff() >= 0 && colour.maxCoeff() <= 1) return colour;
  throw InputError(map.At(key, fmt::format("is [{}, {}, {}]; write red, green and blue as numbers in 0..1",
                                           colour[0], colour[1], colour[2])));
}

std::string ReadName(const YamlMap& map, const std::string& key) {
  std::string name = map.Text(key);
  if (!name.empty() && std::all_of(name.begin(), name.end(), IsNameCharacter)) return name;
  throw InputError(
      map.At(key, fmt::format("is {}; write a word of letters, digits, '-' and '_'", Quoted(name))));
}

std::vector<YamlMap> MapsIfAny(const YamlMap& map, const std::string& key) {
  return map.Has(key) ? map.Maps(key) : std::vector<YamlMap>();
}

}  // namespace armature
