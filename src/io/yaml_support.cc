// SPDX-License-Identifier: BSD-3-Clause
#include "io/yaml_support.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "base/printable.h"
#include "base/text.h"
#include "io/yaml_limits.h"

namespace armature {

YamlMap YamlMap::Load(const std::filesystem::path& file) { return Parse(ReadTextFile(file), file); }

YamlMap YamlMap::Parse(const std::string& content, const std::filesystem::path& file) {
  CheckYaml(content, file);
  return YamlMap(file, YAML::Load(content), "");
}

YamlMap::YamlMap(std::filesystem::path file, const YAML::Node& node, std::string prefix)
    : file_(std::move(file)), node_(node), prefix_(std::move(prefix)) {
  if (!node_.IsMap() && !node_.IsNull()) {
    const std::string name = prefix_.empty() ? "the file" : prefix_.substr(0, prefix_.size() - 1);
    throw InputError(fmt::format("{}:{}: {} has to be a map; write lines of the form 'key: value'",
                                 file_.string(), node_.Mark().line + 1, name));
  }
  std::set<std::string> seen;
  for (const std::string& key : Keys()) {
    if (!seen.insert(key).second) throw InputError(At(key, "is given twice; keep one"));
  }
}

std::vector<std::string> YamlMap::Keys() const {
  std::vector<std::string> keys;
  for (const auto& pair : node_) {
    if (!pair.first.IsScalar()) {
      throw InputError(fmt::format("{}:{}: a key is not a plain word; write 'key: value'", file_.string(),
                                   pair.first.Mark().line + 1));
    }
    if (!IsPrintable(pair.first.Scalar())) {
      throw InputError(
          fmt::format("{}:{}: the key {} has a line break or another control character; write a "
                      "plain word",
                      file_.string(), pair.first.Mark().line + 1, Quoted(pair.first.Scalar())));
    }
    keys.push_back(pair.first.Scalar());
  }
  return keys;
}

bool YamlMap::Has(const std::string& key) const {
  const std::vector<std::string> keys = Keys();
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

std::string YamlMap::FullKey(const std::string& key) const { return prefix_ + key; }

int YamlMap::Line(const std::string& key) const {
  int line = node_.Mark().line;
  for (const auto& pair : node_) {
    if (pair.first.IsScalar() && pair.first.Scalar() == key) line = pair.first.Mark().line;
  }
  return std::max(line, 0) + 1;
}

std::string YamlMap::Where(const std::string& key) const {
  return fmt::format("{}:{}", file_.string(), Line(key));
}

std::string YamlMap::At(const std::string& key, const std::string& message) const {
  return fmt::format("{}: {} {}", Where(key), Quoted(FullKey(key)), message);
}

YAML::Node YamlMap::Value(const std::string& key) const {
  for (const auto& pair : node_) {
    if (pair.first.Scalar() == key) return pair.second;
  }
  throw InputError(At(key, "is missing; add it"));
}

std::string YamlMap::ScalarText(const std::string& key, const YAML::Node& value) const {
  if (!value.IsScalar()) throw InputError(At(key, "has to be a single value; write 'key: value'"));
  std::string text = value.Scalar();
  if (text.ends_with('\n')) text.pop_back();  // of a text written below its key, after '>' or '|'
  if (IsPrintable(text)) return text;
  throw InputError(At(key, fmt::format("is {}, with a line break or another control character; write a plain "
                                       "word",
                                       Quoted(text))));
}

double YamlMap::Number(const std::string& key) const {
  return ParseNumber(ScalarText(key, Value(key)), fmt::format("{}: {}", Where(key), Quoted(FullKey(key))));
}

int YamlMap::Integer(const std::string& key) const {
  return ParseInteger(ScalarText(key, Value(key)), fmt::format("{}: {}", Where(key), Quoted(FullKey(key))));
}

bool YamlMap::Boolean(const std::string& key) const {
  const std::string text = ScalarText(key, Value(key));
  if (text == "true") return true;
  if (text == "false") return false;
  throw InputError(At(key, fmt::format("is {}; write true or false", Quoted(text))));
}

std::string YamlMap::Text(const std::string& key) const { return ScalarText(key, Value(key)); }

std::vector<std::string> YamlMap::Texts(const std::string& key) const {
  const YAML::Node list = Value(key);
  if (!list.IsSequence()) throw InputError(At(key, "has to be a list; write [first, second]"));
  std::vector<std::string> texts;
  for (const YAML::Node& item : list) texts.push_back(ScalarText(key, item));
  return texts;
}

std::vector<double> YamlMap::Numbers(const std::string& key) const {
  const std::string where = fmt::format("{}: {}", Where(key), Quoted(FullKey(key)));
  std::vector<double> numbers;
  for (const std::string& text : Texts(key)) numbers.push_back(ParseNumber(text, where));
  return numbers;
}

YamlMap YamlMap::Map(const std::string& key) const { return YamlMap(file_, Value(key), FullKey(key) + "."); }

YamlMap YamlMap::MapOrEmpty(const std::string& key) const {
  return Has(key) ? Map(key) : YamlMap(file_, YAML::Node(), FullKey(key) + ".");
}

std::vector<YamlMap> YamlMap::Maps(const std::string& key) const {
  const YAML::Node list = Value(key);
  if (!list.IsSequence()) {
    throw InputError(At(key, "has to be a list of maps; write lines of the form '- {key: value}'"));
  }
  std::vector<YamlMap> maps;
  for (const YAML::Node& item : list) {
    maps.push_back(YamlMap(file_, item, fmt::format("{}[{}].", FullKey(key), maps.size())));
  }
  return maps;
}

bool YamlMap::IsMap(const std::string& key) const { return Value(key).IsMap(); }

bool YamlMap::IsList(const std::string& key) const { return Value(key).IsSequence(); }

void YamlMap::CheckKeys(const std::vector<std::string>& known) const {
  for (const std::string& key : Keys()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    throw InputError(fmt::format("{}: {}", Where(key), UnknownNameMessage("key", key, known)));
  }
}

}  // namespace armature
