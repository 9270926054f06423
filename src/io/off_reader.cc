// SPDX-License-Identifier: BSD-3-Clause
#include "io/off_reader.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "base/errors.h"
#include "base/text.h"
#include "io/mesh_builder.h"

namespace armature {
namespace {

// The words of all lines in turn.
class OffWords {
 public:
  OffWords(const std::filesystem::path& file, std::vector<TextLine> lines)
      : file_(file), lines_(std::move(lines)) {
    if (!lines_.empty()) words_ = SplitWords(lines_[0].text);
  }

  bool AtEnd() {
    while (word_ == words_.size() && line_ + 1 < lines_.size()) BeginLine(line_ + 1);
    return word_ == words_.size();
  }

  const std::string& Next(const char* what) {
    if (AtEnd()) {
      throw InputError(fmt::format("{}: ends where {} should be; copy it again", Where(), what));
    }
    return words_[word_++];
  }

  int NextInteger(const char* what) {
    const std::string& word = Next(what);
    return ParseInteger(word, Where());
  }

  // Whatever is left of the line.
  void SkipLine() { word_ = words_.size(); }

  size_t WordsLeft() const {
    size_t words = WordsLeftInLine();
    for (size_t line = line_ + 1; line < lines_.size(); ++line) words += SplitWords(lines_[line].text).size();
    return words;
  }
  size_t WordsLeftInLine() const { return words_.size() - word_; }
  size_t LinesBelow() const { return lines_.size() - line_ - 1; }
  size_t WordsOfNextLine() const { return LinesBelow() == 0 ? 0 : SplitWords(lines_[line_ + 1].text).size(); }
  // Whether each of the next lines begins a face and names its corners.
  bool AreLinesOfFaces(size_t faces) const {
    if (WordsLeftInLine() > 0 || LinesBelow() < faces) return false;
    for (size_t line = line_ + 1; line <= line_ + faces; ++line) {
      const std::vector<std::string> face = SplitWords(lines_[line].text);
      const int corners = ParseInteger(face[0], Where());
      if (corners < 1 || face.size() <= static_cast<size_t>(corners)) return false;
    }
    return true;
  }
  int line() const { return lines_.empty() ? 1 : lines_[line_].number; }
  std::string Where() const { return fmt::format("{}:{}", file_.string(), line()); }

 private:
  void BeginLine(size_t line) {
    line_ = line;
    words_ = SplitWords(lines_[line].text);
    word_ = 0;
  }

  const std::filesystem::path& file_;
  std::vector<TextLine> lines_;
  std::vector<std::string> words_;
  size_t line_ = 0, word_ = 0;
};

struct OffHead {
  size_t vertex_numbers = 3;  // of each vertex
  size_t vertices = 0, faces = 0;
};

// "STCNOFF": what each vertex has beside its place. What follows the last F is left in `keyword`.
size_t ReadOffKeyword(const std::filesystem::path& file, std::string& keyword) {
  std::string_view rest = keyword;
  const auto take = [&rest](std::string_view start) {
    const bool is_there = rest.starts_with(start);
    if (is_there) rest.remove_prefix(start.size());
    return is_there;
  };
  const size_t texture = take("ST") ? 2 : 0, colour = take("C") ? 4 : 0, normal = take("N") ? 3 : 0;
  if (rest.starts_with("4") || rest.starts_with("n"))
    throw InputError(fmt::format("{}: has points of other than three dimensions; write OFF", file.string()));
  if (!take("OFF")) {
    throw InputError(
        fmt::format("{}: does not start with OFF; convert it to OFF, PLY or OBJ", file.string()));
  }
  keyword = rest;
  return 3 + texture + colour + normal;
}

size_t CheckedCount(int count, const OffWords& words) {
  if (count >= 0) return static_cast<size_t>(count);
  throw InputError(fmt::format("{}: write the numbers of vertices, faces and edges", words.Where()));
}

OffHead ReadOffHead(const std::filesystem::path& file, OffWords& words) {
  OffHead head;
  std::string keyword = words.AtEnd() ? "" : words.Next("OFF");
  head.vertex_numbers = ReadOffKeyword(file, keyword);
  if (keyword.empty() && words.AtEnd())
    throw InputError(fmt::format("{}: ends after OFF; copy it again", file.string()));
  const char* what = "the numbers of vertices, faces and edges";
  const std::string first = keyword.empty() ? words.Next(what) : keyword;
  if (first == "BINARY")
    throw InputError(fmt::format("{}: is a binary OFF file; convert it to text", file.string()));
  head.vertices = CheckedCount(ParseInteger(first, words.Where()), words);
  head.faces = CheckedCount(words.NextInteger(what), words);
  // The number of edges says nothing, and is left out by some.
  if (words.WordsLeftInLine() > 0 || words.WordsOfNextLine() == 1) words.NextInteger(what);
  return head;
}

// Three numbers a vertex, two a face at least, before anything is made of them.
void CheckEnough(const std::filesystem::path& file, const OffHead& head, size_t numbers) {
  if (numbers >= 3 * head.vertices + 2 * head.faces) return;
  throw InputError(fmt::format("{}: says {} vertices and {} faces, but only {} numbers follow; copy it again",
                               file.string(), head.vertices, head.faces, numbers));
}

void ReadOffVertex(const OffHead& head, bool is_line, OffWords& words, MeshBuilder& mesh) {
  Eigen::Vector3d vertex;
  for (double& coordinate : vertex) {
    const std::string& word = words.Next("a vertex");
    coordinate = ParseNumber(word, words.Where());
    if (is_line && words.WordsLeftInLine() == 0 && &coordinate != &vertex[2])
      throw InputError(fmt::format("{}: a vertex needs three numbers: x, y and z", words.Where()));
  }
  mesh.AddVertex(vertex, words.line());
  for (size_t i = 3; !is_line && i < head.vertex_numbers; ++i) words.Next("a vertex");
  if (is_line) words.SkipLine();
}

void ReadOffFace(bool is_line, OffWords& words, MeshBuilder& mesh) {
  const int count = words.NextInteger("a face");
  const size_t named = words.WordsLeftInLine();
  if (count < 0 || (is_line && named < static_cast<size_t>(count))) {
    throw InputError(fmt::format("{}: a face says {} corners and names {}", words.Where(), count, named));
  }
  std::vector<std::int64_t> corners;
  for (int i = 0; i < count; ++i) corners.push_back(words.NextInteger("a corner of a face"));
  mesh.AddPolygon(corners, words.line());
  if (is_line) words.SkipLine();
}

}  // namespace

TriangleMesh ReadOff(const std::filesystem::path& file) {
  OffWords words(file, ReadTextLines(file));
  const OffHead head = ReadOffHead(file, words);
  CheckEnough(file, head, words.WordsLeft());
  const bool has_lines = words.WordsLeftInLine() == 0 && words.LinesBelow() >= head.vertices + head.faces;
  MeshBuilder mesh(file);
  for (size_t i = 0; i < head.vertices; ++i) ReadOffVertex(head, has_lines, words, mesh);
  const bool has_face_lines = has_lines || words.AreLinesOfFaces(head.faces);
  for (size_t i = 0; i < head.faces; ++i) ReadOffFace(has_face_lines, words, mesh);
  return mesh.Build();
}

}  // namespace armature
