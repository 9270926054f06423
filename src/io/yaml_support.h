// SPDX-License-Identifier: BSD-3-Clause
// Reading YAML maps with messages that name file and line.
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <string>
#include <vector>

namespace armature {

// A map of a YAML file. Every access throws InputError("file:line: ...") when the key is missing or of
// another type.
class YamlMap {
 public:
  // Reads the file, whose top level has to be a map; an empty file is an empty map.
  static YamlMap Load(const std::filesystem::path& file);
  // The same of its content; messages name the file.
  static YamlMap Parse(const std::string& content, const std::filesystem::path& file);

  bool Has(const std::string& key) const;
  double Number(const std::string& key) const;  // finite
  int Integer(const std::string& key) const;
  bool Boolean(const std::string& key) const;  // true or false
  std::string Text(const std::string& key) const;
  std::vector<double> Numbers(const std::string& key) const;  // a list of finite numbers
  std::vector<std::string> Texts(const std::string& key) const;
  YamlMap Map(const std::string& key) const;
  YamlMap MapOrEmpty(const std::string& key) const;         // an empty map when the key is absent
  std::vector<YamlMap> Maps(const std::string& key) const;  // a list of maps; "objects[2].id" in messages
  std::vector<std::string> Keys() const;                    // in the order of the file

  // Whether the key holds a map, a list.
  bool IsMap(const std::string& key) const;
  bool IsList(const std::string& key) const;
  // Throws InputError for a key that is not among the known ones, naming the nearest of them.
  void CheckKeys(const std::vector<std::string>& known) const;
  // "file:line: `key` message" with the line of the key (of the map when it is absent), ready to be thrown.
  // The key is written with the keys of the maps around it ("camera.fx").
  std::string At(const std::string& key, const std::string& message) const;
  // The same without the key's name in the message.
  std::string Where(const std::string& key) const;
  // That line, from 1.
  int Line(const std::string& key) const;

 private:
  YamlMap(std::filesystem::path file, const YAML::Node& node, std::string prefix);
  YAML::Node Value(const std::string& key) const;
  std::string ScalarText(const std::string& key, const YAML::Node& value) const;
  std::string FullKey(const std::string& key) const;

  std::filesystem::path file_;
  YAML::Node node_;
  std::string prefix_;  // "camera." inside of camera
};

}  // namespace armature
