// SPDX-License-Identifier: BSD-3-Clause
#include "io/yaml_limits.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "base/errors.h"

namespace armature {
namespace {

constexpr size_t kMostYamlBytes = 16 << 20;
constexpr long kMostNodes = 200'000;  // a category has about a thousand
constexpr int kMostLevels = 64;       // settings have four

// What stands in the tree at one place, aliases written out.
struct YamlExtent {
  long nodes = 1;
  int levels = 1;
};

class YamlLimits : public YAML::EventHandler {
 public:
  explicit YamlLimits(const std::filesystem::path& file) : file_(file) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ > 1) Refuse(mark, "a second document begins; keep one document a file");
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { AddLeaf(mark, anchor); }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                const std::string&) override {
    AddLeaf(mark, anchor);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto meant = closed_.find(anchor);
    if (meant == closed_.end()) Refuse(mark, "an alias stands inside of what it stands for; write it out");
    Add(mark, meant->second);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    Open(mark, anchor);
  }
  void OnSequenceEnd() override { Close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    Open(mark, anchor);
  }
  void OnMapEnd() override { Close(); }

 private:
  struct OpenNode {
    YAML::Mark mark;
    YAML::anchor_t anchor;
    YamlExtent extent;
  };

  [[noreturn]] void Refuse(const YAML::Mark& mark, const std::string& why) const {
    throw InputError(fmt::format("{}:{}: {}", file_.string(), mark.line + 1, why));
  }

  void AddLeaf(const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (anchor != 0) closed_[anchor] = {};
    Add(mark, {});
  }

  // To the innermost node that is open.
  void Add(const YAML::Mark& mark, const YamlExtent& added) {
    if (open_.empty()) return;
    YamlExtent& extent = open_.back().extent;
    extent.nodes += added.nodes;
    extent.levels = std::max(extent.levels, 1 + added.levels);
    if (extent.nodes > kMostNodes) {
      Refuse(mark,
             fmt::format("more than {} values, with aliases written out; give a smaller file", kMostNodes));
    }
    CheckLevels(mark, static_cast<int>(open_.size()) + added.levels);
  }

  void Open(const YAML::Mark& mark, YAML::anchor_t anchor) {
    open_.push_back({mark, anchor, {}});
    CheckLevels(mark, static_cast<int>(open_.size()));
  }

  void Close() {
    const OpenNode node = open_.back();
    open_.pop_back();
    if (node.anchor != 0) closed_[node.anchor] = node.extent;
    Add(node.mark, node.extent);
  }

  void CheckLevels(const YAML::Mark& mark, int levels) const {
    if (levels <= kMostLevels) return;
    Refuse(mark, fmt::format("lists and maps are more than {} levels deep; write fewer", kMostLevels));
  }

  const std::filesystem::path& file_;
  int documents_ = 0;
  std::vector<OpenNode> open_;
  std::map<YAML::anchor_t, YamlExtent> closed_;  // of anchors whose node has ended
};

// yaml-cpp ends a file at some of them without a word.
void CheckYamlCharacters(const std::string& content, const std::filesystem::path& file) {
  const auto is_bad = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7F;
  };
  const auto bad = std::find_if(content.begin(), content.end(), is_bad);
  if (bad == content.end()) return;
  throw InputError(
      fmt::format("{}:{}: holds a control character, which YAML does not allow; save it as text "
                  "in UTF-8",
                  file.string(), 1 + std::count(content.begin(), bad, '\n')));
}

}  // namespace

void CheckYaml(const std::string& content, const std::filesystem::path& file) {
  if (content.size() > kMostYamlBytes) {
    throw InputError(
        fmt::format("{}: is larger than {} MB; give a smaller file", file.string(), kMostYamlBytes >> 20));
  }
  CheckYamlCharacters(content, file);
  std::istringstream stream(content);
  YamlLimits limits(file);
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(limits)) {
    }
  } catch (const YAML::Exception& error) {
    throw InputError(fmt::format("{}:{}: not valid YAML ({}); check indentation, colons and brackets",
                                 file.string(), error.mark.line + 1, error.msg));
  }
}

}  // namespace armature
