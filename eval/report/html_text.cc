// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/html_text.h"

#include <algorithm>
#include <stdexcept>

namespace armature {
namespace {

std::string_view Entity(char c) {
  switch (c) {
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '&':
      return "&amp;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {};
  }
}

}  // namespace

std::string EscapedHtml(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (const char& c : text) {
    const std::string_view entity = Entity(c);
    escaped += entity.empty() ? std::string_view(&c, 1) : entity;
  }
  return escaped;
}

std::string EscapedJson(std::string_view json) {
  std::string escaped;
  escaped.reserve(json.size());
  for (const char& c : json) escaped += c == '<' ? std::string_view("\\u003c") : std::string_view(&c, 1);
  return escaped;
}

std::string_view CheckedScript(std::string_view script) {
  for (const std::string_view forbidden : {"</script", "</style", "<!--"}) {
    if (script.find(forbidden) != std::string_view::npos) {
      throw std::logic_error("an inlined script must not contain " + std::string(forbidden));
    }
  }
  return script;
}

std::string Base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t count = std::min<size_t>(3, bytes.size() - i);  // bytes of this group
    unsigned bits = 0;
    for (size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string DataUrl(const std::string& mime, std::string_view bytes) {
  return "data:" + mime + ";base64," + Base64(bytes);
}

}  // namespace armature
