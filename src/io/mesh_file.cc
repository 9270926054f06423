// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "base/errors.h"
#include "base/text.h"
#include "geometry/mesh_shapes.h"
#include "geometry/triangle_mesh.h"
#include "io/box_table.h"
#include "io/mesh_builder.h"
#include "io/ply_reader.h"

namespace armature {
namespace {

using Words = std::vector<std::string>;

Words SplitWords(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
}

// Three words from `first` on are the coordinates.
void AddVertex(const Words& words, size_t first, int line, MeshBuilder& mesh) {
  if (words.size() < first + 3) {
    throw InputError(fmt::format("{}: a vertex has {} numbers where x, y and z are needed", mesh.At(line),
                                 words.size() - first));
  }
  Eigen::Vector3d vertex;
  for (size_t i = 0; i < 3; ++i) {
    vertex[static_cast<Eigen::Index>(i)] = ParseNumber(words[first + i], mesh.At(line));
  }
  mesh.AddVertex(vertex, line);
}

// "7", "7/1", "7//3", "7/1/3" or "-1"; from 1, or backwards from the last vertex.
std::int64_t ObjCorner(const std::string& field, int line, const MeshBuilder& mesh) {
  const std::int64_t index = ParseInteger(field.substr(0, field.find('/')), mesh.At(line));
  if (index == 0) {
    throw InputError(fmt::format("{}: a face has a corner at vertex 0; OBJ counts from 1", mesh.At(line)));
  }
  return index > 0 ? index - 1 : mesh.vertices() + index;
}

void AddObjLine(const TextLine& line, MeshBuilder& mesh) {
  const Words words = SplitWords(line.text);
  if (words[0] == "v") return AddVertex(words, 1, line.number, mesh);
  if (words[0] != "f") return;
  std::vector<std::int64_t> corners;
  for (size_t i = 1; i < words.size(); ++i) corners.push_back(ObjCorner(words[i], line.number, mesh));
  mesh.AddPolygon(corners, line.number);
}

void AddOffFace(const TextLine& line, MeshBuilder& mesh) {
  const Words words = SplitWords(line.text);
  const std::string where = mesh.At(line.number);
  const int count = ParseInteger(words[0], where);
  if (count < 0 || words.size() - 1 < static_cast<size_t>(count)) {
    throw InputError(fmt::format("{}: a face says {} corners and names {}", where, count, words.size() - 1));
  }
  std::vector<std::int64_t> corners;
  for (size_t i = 1; i <= static_cast<size_t>(count); ++i) corners.push_back(ParseInteger(words[i], where));
  mesh.AddPolygon(corners, line.number);
}

struct OffCounts {
  size_t vertices = 0, faces = 0;
  size_t lines = 0;  // that the head takes
};

OffCounts ReadOffCounts(const std::filesystem::path& file, const std::vector<TextLine>& lines) {
  if (lines.empty() || !lines[0].text.starts_with("OFF")) {
    throw InputError(
        fmt::format("{}: does not start with OFF; convert it to OFF, PLY or OBJ", file.string()));
  }
  const std::string rest = Trimmed(lines[0].text.substr(3));
  const size_t head = rest.empty() ? 2 : 1;
  if (lines.size() < head) throw InputError(fmt::format("{}: ends after OFF; copy it again", file.string()));
  const std::string where = fmt::format("{}:{}", file.string(), lines[head - 1].number);
  const Words counts = SplitWords(rest.empty() ? lines[1].text : rest);
  const int vertices = ParseInteger(counts[0], where);
  const int faces = counts.size() < 2 ? -1 : ParseInteger(counts[1], where);
  if (vertices < 0 || faces < 0) {
    throw InputError(fmt::format("{}: write the numbers of vertices, faces and edges", where));
  }
  return {static_cast<size_t>(vertices), static_cast<size_t>(faces), head};
}

// Vertices (v) and faces (f, also a/b/c and negative indices); all else is left out. PCL's reader is not
// used: it writes beyond its memory where a file has more normals than vertices, as many have. Throws as
// ReadMesh.
TriangleMesh ReadObj(const std::filesystem::path& file) {
  MeshBuilder mesh(file);
  for (const TextLine& line : ReadTextLines(file)) AddObjLine(line, mesh);
  return mesh.Build();
}

// A vertex or a face a line; what follows a face's corners, its colour, is left out. The first line may go on
// with the counts, as some of ModelNet40 do ("OFF490 518 0"). Throws as ReadMesh.
TriangleMesh ReadOff(const std::filesystem::path& file) {
  const std::vector<TextLine> lines = ReadTextLines(file);
  const OffCounts counts = ReadOffCounts(file, lines);
  if (lines.size() - counts.lines < counts.vertices + counts.faces) {
    throw InputError(fmt::format("{}: says {} vertices and {} faces, but only {} lines follow; copy it again",
                                 file.string(), counts.vertices, counts.faces, lines.size() - counts.lines));
  }
  MeshBuilder mesh(file);
  const TextLine* line = lines.data() + counts.lines;
  for (size_t i = 0; i < counts.vertices; ++i, ++line)
    AddVertex(SplitWords(line->text), 0, line->number, mesh);
  for (size_t i = 0; i < counts.faces; ++i, ++line) AddOffFace(*line, mesh);
  return mesh.Build();
}

std::string LowerCase(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

}  // namespace

TriangleMesh ReadMesh(const std::filesystem::path& file) {
  const std::string ending = LowerCase(file.extension().string());
  if (ending == ".ply") return ReadPly(file);
  if (ending == ".obj") return ReadObj(file);
  if (ending == ".off") return ReadOff(file);
  throw InputError(
      fmt::format("{}: is no name of a mesh; give one that ends in .ply, .obj or .off", file.string()));
}

TriangleMesh ReadBoxes(const std::filesystem::path& file, const std::string& id) {
  TriangleMesh mesh;
  for (const TextLine& line : ReadTextLines(file)) {
    if (line.text.find(id) == std::string::npos) continue;  // most lines: not worth parsing
    const TableBox box = ParseTableBox(file, line);
    if (std::ranges::find(box.ids, id) == box.ids.end()) continue;
    Append(BoxMesh(box.centre, box.half_axes), ColourBytes::Zero(), mesh);
  }
  if (mesh.size() == 0) throw InputError(fmt::format("{}: has no box of {}", file.string(), Quoted(id)));
  mesh.colours.resize(3, 0);
  return mesh;
}

TriangleMesh ReadGeometry(const std::filesystem::path& file_and_id) {
  const std::string text = file_and_id.string();
  const size_t mark = text.rfind('#');
  if (mark == std::string::npos) return ReadMesh(file_and_id);
  return ReadBoxes(text.substr(0, mark), text.substr(mark + 1));
}

}  // namespace armature
