// SPDX-License-Identifier: BSD-3-Clause
#include "io/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "base/text.h"

namespace armature {
namespace {

constexpr int kMostHeaderLines = 1000;

struct ScalarName {
  const char* name;
  PlyScalar type;
};

using ScalarKind = PlyScalar::Kind;

constexpr ScalarName kScalarNames[] = {
    {"char", {ScalarKind::kSigned, 1}},     {"int8", {ScalarKind::kSigned, 1}},
    {"uchar", {ScalarKind::kUnsigned, 1}},  {"uint8", {ScalarKind::kUnsigned, 1}},
    {"short", {ScalarKind::kSigned, 2}},    {"int16", {ScalarKind::kSigned, 2}},
    {"ushort", {ScalarKind::kUnsigned, 2}}, {"uint16", {ScalarKind::kUnsigned, 2}},
    {"int", {ScalarKind::kSigned, 4}},      {"int32", {ScalarKind::kSigned, 4}},
    {"uint", {ScalarKind::kUnsigned, 4}},   {"uint32", {ScalarKind::kUnsigned, 4}},
    {"int64", {ScalarKind::kSigned, 8}},    {"uint64", {ScalarKind::kUnsigned, 8}},
    {"float", {ScalarKind::kReal, 4}},      {"float32", {ScalarKind::kReal, 4}},
    {"double", {ScalarKind::kReal, 8}},     {"float64", {ScalarKind::kReal, 8}}};

class PlyHeaderReader {
 public:
  PlyHeaderReader(std::string_view content, const std::filesystem::path& file)
      : content_(content), file_(file) {}

  PlyHeader Read() {
    FindLineEnd();
    if (Trimmed(NextLine()) != "ply") Refuse("does not start with 'ply'; convert it to PLY, OBJ or OFF");
    while (true) {
      const std::vector<std::string> words = SplitWords(NextLine());
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") break;
      Add(words);
    }
    if (!has_format_) Refuse("has no line 'format'; write 'format ascii 1.0'");
    return std::move(header_);
  }

 private:
  [[noreturn]] void Refuse(const std::string& reason) const {
    throw InputError(fmt::format("{}:{}: {}", file_.string(), std::max(header_.lines, 1), reason));
  }

  // The first line's end is every line's: a CR may otherwise end the header, and an LF begin the data.
  void FindLineEnd() {
    const size_t end = content_.find_first_of("\r\n");
    if (end == std::string_view::npos) return;
    if (content_[end] == '\r') line_end_ = content_.substr(end).starts_with("\r\n") ? "\r\n" : "\r";
  }

  std::string_view NextLine() {
    const size_t end = content_.find(line_end_, header_.bytes);
    if (end == std::string_view::npos || ++header_.lines > kMostHeaderLines) {
      throw InputError(
          fmt::format("{}: is no PLY file: its header does not end; copy it again", file_.string()));
    }
    const std::string_view line = content_.substr(header_.bytes, end - header_.bytes);
    header_.bytes = end + line_end_.size();
    return line;
  }

  void Add(const std::vector<std::string>& words) {
    if (words[0] == "format") return SetFormat(words);
    if (words[0] == "element") return AddElement(words);
    if (words[0] == "property") return AddProperty(words);
    Refuse(UnknownNameMessage("PLY keyword", words[0],
                              {"format", "comment", "obj_info", "element", "property", "end_header"}));
  }

  void SetFormat(const std::vector<std::string>& words) {
    static const std::vector<std::string> kFormats{"ascii", "binary_little_endian", "binary_big_endian"};
    const std::string name = words.size() < 2 ? "" : words[1];
    const auto found = std::find(kFormats.begin(), kFormats.end(), name);
    if (found == kFormats.end()) Refuse(UnknownNameMessage("PLY format", name, kFormats));
    header_.format = static_cast<PlyFormat>(found - kFormats.begin());
    has_format_ = true;
  }

  void AddElement(const std::vector<std::string>& words) {
    std::uint64_t count = 0;
    const bool has_count = words.size() == 3 && ParseCount(words[2], count);
    if (!has_count) Refuse("an element needs a name and a number; write 'element vertex 8'");
    for (const PlyElement& element : header_.elements) {
      if (element.name == words[1]) Refuse(fmt::format("has the element {} twice", Quoted(words[1])));
    }
    header_.elements.push_back({words[1], count, {}});
  }

  static bool ParseCount(const std::string& text, std::uint64_t& count) {
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, count);
    return error == std::errc() && rest == end;
  }

  void AddProperty(const std::vector<std::string>& words) {
    if (header_.elements.empty()) Refuse("a property stands before the first element");
    const bool is_list = words.size() == 5 && words[1] == "list";
    if (!is_list && words.size() != 3)
      Refuse("a property is 'property float x' or 'property list uchar int vertex_indices'");
    PlyElement& element = header_.elements.back();
    if (element.Find(words.back())) Refuse(fmt::format("has the property {} twice", Quoted(words.back())));
    PlyProperty property{words.back(), FindScalar(words[is_list ? 3 : 1]), {}};
    if (is_list) property.count = FindScalar(words[2]);
    element.properties.push_back(std::move(property));
  }

  PlyScalar FindScalar(const std::string& name) const {
    std::vector<std::string> known;
    for (const ScalarName& scalar : kScalarNames) {
      if (name == scalar.name) return scalar.type;
      known.emplace_back(scalar.name);
    }
    Refuse(UnknownNameMessage("PLY type", name, known));
  }

  std::string_view content_;
  const std::filesystem::path& file_;
  std::string_view line_end_ = "\n";
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

std::optional<size_t> PlyElement::Find(std::string_view property) const {
  for (size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == property) return i;
  }
  return std::nullopt;
}

PlyHeader ReadPlyHeader(std::string_view content, const std::filesystem::path& file) {
  return PlyHeaderReader(content, file).Read();
}

}  // namespace armature
