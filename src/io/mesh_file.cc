// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "base/text.h"
#include "geometry/mesh_shapes.h"
#include "io/box_table.h"
#include "io/ply_reader.h"
#include "io/text_mesh.h"

namespace armature {
namespace {

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
