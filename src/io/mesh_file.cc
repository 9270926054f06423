// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.h"
#include "base/text.h"
#include "geometry/mesh_shapes.h"
#include "geometry/triangle_mesh.h"
#include "io/box_table.h"
#include "io/mesh_builder.h"
#include "io/off_reader.h"
#include "io/ply_reader.h"

namespace armature {
namespace {

using Words = std::vector<std::string>;

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
  if (words.empty()) return;  // a backslash alone
  if (words[0] == "v") return AddVertex(words, 1, line.number, mesh);
  if (words[0] != "f") return;
  std::vector<std::int64_t> corners;
  for (size_t i = 1; i < words.size(); ++i) corners.push_back(ObjCorner(words[i], line.number, mesh));
  mesh.AddPolygon(corners, line.number);
}

// A line that ends in a backslash goes on in the next one.
std::vector<TextLine> JoinedLines(std::vector<TextLine> lines) {
  std::vector<TextLine> joined;
  bool goes_on = false;
  for (TextLine& line : lines) {
    const bool continues = goes_on;
    goes_on = line.text.ends_with('\\');
    if (goes_on) line.text.back() = ' ';
    if (continues) {
      joined.back().text += line.text;
    } else {
      joined.push_back(std::move(line));
    }
  }
  return joined;
}

// Vertices (v) and faces (f, also a/b/c and negative indices); all else is left out. PCL's reader is not
// used: it writes beyond its memory where a file has more normals than vertices, as many have. Throws as
// ReadMesh.
TriangleMesh ReadObj(const std::filesystem::path& file) {
  MeshBuilder mesh(file);
  for (const TextLine& line : JoinedLines(ReadTextLines(file))) AddObjLine(line, mesh);
  return mesh.Build();
}

struct GeometryName {
  std::filesystem::path file;
  std::string box;  // its id in a table of boxes; empty: the file is a mesh
};

// A '#' may stand in the names of folders and files, too: the whole, or else the first part that is a file.
std::optional<GeometryName> SplitGeometry(const std::filesystem::path& file_and_id) {
  const std::string text = file_and_id.string();
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file_and_id, ignored)) return GeometryName{file_and_id, ""};
  for (size_t mark = text.find('#'); mark != std::string::npos; mark = text.find('#', mark + 1)) {
    if (std::filesystem::is_regular_file(text.substr(0, mark), ignored))
      return GeometryName{text.substr(0, mark), text.substr(mark + 1)};
  }
  return std::nullopt;
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

bool HasGeometry(const std::filesystem::path& file_and_id) { return SplitGeometry(file_and_id).has_value(); }

TriangleMesh ReadGeometry(const std::filesystem::path& file_and_id) {
  const std::optional<GeometryName> found = SplitGeometry(file_and_id);
  if (found) return found->box.empty() ? ReadMesh(found->file) : ReadBoxes(found->file, found->box);
  // To say what is missing.
  const std::string text = file_and_id.string();
  return ReadMesh(text.substr(0, text.find('#', text.rfind('/') + 1)));
}

}  // namespace armature
