// SPDX-License-Identifier: BSD-3-Clause
#include "io/ply_reader.h"

#include <fmt/format.h>
#include <pcl/PolygonMesh.h>
#include <pcl/console/print.h>
#include <pcl/conversions.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "base/errors.h"
#include "base/text.h"
#include "io/mesh_builder.h"

namespace armature {
namespace {

constexpr int kMostLines = 1000;

struct Header {
  std::set<std::string> elements;
  std::set<std::string> coordinates;  // of vertices, those that are float or double
  std::string element;                // that the properties belong to
};

class HeaderReader {
 public:
  explicit HeaderReader(const std::filesystem::path& file)
      : file_(file), bytes_(std::filesystem::file_size(file)), stream_(file, std::ios::binary) {}

  void Check() {
    if (NextLine() != "ply") Refuse("does not start with 'ply'; convert it to PLY, OBJ or OFF");
    for (std::string line = NextLine(); line != "end_header"; line = NextLine()) Add(line);
    for (const char* needed : {"vertex", "face"}) {
      if (!header_.elements.contains(needed)) Refuse(fmt::format("has no element '{}'", needed));
    }
    if (header_.coordinates.size() != 3) Refuse("its vertices need x, y and z, as float or double");
  }

 private:
  [[noreturn]] void Refuse(const std::string& reason) const {
    throw InputError(fmt::format("{}: {}", file_.string(), reason));
  }

  std::string NextLine() {
    std::string line;
    if (++lines_ > kMostLines || !std::getline(stream_, line)) {
      Refuse("is no PLY file: its header does not end; copy it again");
    }
    return Trimmed(line);
  }

  void Add(const std::string& line) {
    std::istringstream fields(line);
    std::string keyword;
    fields >> keyword;
    if (keyword == "element") AddElement(fields);
    if (keyword == "property" && header_.element == "vertex") AddVertexProperty(fields);
    // PCL takes the size of a grid from there, and writes the vertices beyond it.
    if (keyword == "obj_info" && line.find("num_") != std::string::npos) {
      Refuse("is a range image; give a surface");
    }
  }

  void AddElement(std::istringstream& fields) {
    std::uint64_t count = 0;
    if (!(fields >> header_.element >> count)) Refuse("an element needs a name and a number");
    if (!header_.elements.insert(header_.element).second) {
      Refuse(fmt::format("has the element {} twice", Quoted(header_.element)));
    }
    if (count > bytes_) {
      Refuse(fmt::format("says {} of element {}, but has only {} bytes; copy it again", count,
                         Quoted(header_.element), bytes_));
    }
  }

  void AddVertexProperty(std::istringstream& fields) {
    static const std::array<std::string, 4> kReal = {"float", "float32", "double", "float64"};
    std::string type, name;
    fields >> type >> name;
    if (type == "list") Refuse("its vertices have lists; write plain vertices");
    const bool is_coordinate = name == "x" || name == "y" || name == "z";
    if (is_coordinate && std::ranges::find(kReal, type) != kReal.end()) header_.coordinates.insert(name);
  }

  std::filesystem::path file_;
  std::uintmax_t bytes_;
  std::ifstream stream_;
  Header header_;
  int lines_ = 0;
};

// Whether the file may be handed to PCL, which allocates whatever its header claims. Throws InputError naming
// the file: it cannot be read, does not start as PLY does, its header does not end or claims more elements
// than the file has bytes, has no vertices with float or double x, y and z or no faces, or belongs to a range
// image.
void CheckPlyHeader(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file) || !std::ifstream(file)) {
    throw InputError(
        fmt::format("{}: cannot be opened; check that it exists and may be read", file.string()));
  }
  HeaderReader(file).Check();
}

// PCL tells on stderr about every property that it leaves out.
void SilencePcl() { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); }

[[noreturn]] void ThrowMalformed(const std::filesystem::path& file) {
  throw InputError(fmt::format("{}: is cut short or malformed; copy or write it again", file.string()));
}

pcl::PolygonMesh LoadPolygons(const std::filesystem::path& file) {
  SilencePcl();
  pcl::PolygonMesh polygons;
  try {
    if (pcl::PLYReader().read(file.string(), polygons) == 0) return polygons;
  } catch (const std::exception&) {  // of PCL, Boost or the standard library, whatever the file provokes
  }
  ThrowMalformed(file);
}

const pcl::PCLPointField& FindField(const pcl::PCLPointCloud2& cloud, const std::string& name,
                                    const std::filesystem::path& file) {
  for (const pcl::PCLPointField& field : cloud.fields) {
    if (field.name == name) return field;
  }
  ThrowMalformed(file);
}

double RealAt(const std::uint8_t* bytes, int datatype) {
  if (datatype == pcl::PCLPointField::FLOAT64) {
    double value = 0;
    std::memcpy(&value, bytes, sizeof value);
    return value;
  }
  float value = 0;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

void AddVertices(const pcl::PCLPointCloud2& cloud, const std::filesystem::path& file, MeshBuilder& mesh) {
  const std::array fields{FindField(cloud, "x", file), FindField(cloud, "y", file),
                          FindField(cloud, "z", file)};
  // The cloud's width may come from a camera in the file: only the data tell how many vertices there are.
  for (size_t first = 0; first + cloud.point_step <= cloud.data.size(); first += cloud.point_step) {
    Eigen::Vector3d vertex;
    for (int i = 0; i < 3; ++i) {
      const pcl::PCLPointField& field = fields[static_cast<size_t>(i)];
      vertex[i] = RealAt(cloud.data.data() + first + field.offset, field.datatype);
    }
    mesh.AddVertex(vertex, 0);
  }
}

}  // namespace

TriangleMesh ReadPly(const std::filesystem::path& file) {
  CheckPlyHeader(file);
  const pcl::PolygonMesh polygons = LoadPolygons(file);
  MeshBuilder mesh(file);
  AddVertices(polygons.cloud, file, mesh);
  for (const pcl::Vertices& polygon : polygons.polygons) {
    const std::vector<std::int64_t> corners(polygon.vertices.begin(), polygon.vertices.end());
    mesh.AddPolygon(corners, 0);
  }
  return mesh.Build();
}

}  // namespace armature
