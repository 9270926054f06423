// SPDX-License-Identifier: BSD-3-Clause
// Texts and bytes as parts of an HTML file.
#pragma once

#include <string>
#include <string_view>

namespace armature {

// For the content of an element and for an attribute in quotes: < > & " ' as entities.
std::string EscapedHtml(std::string_view text);

// JSON for the inside of a script element, which would end at the first "</script": < as \u003c, its like in
// every string of JSON.
std::string EscapedJson(std::string_view json);

// The script itself. Throws std::logic_error: it holds a text that would end its element or hide the end.
std::string_view CheckedScript(std::string_view script);

std::string Base64(std::string_view bytes);

// "data:image/png;base64,..."; to be escaped like any other text.
std::string DataUrl(const std::string& mime, std::string_view bytes);

}  // namespace armature
