// SPDX-License-Identifier: BSD-3-Clause
#include "io/ply_mesh.h"

#include <fmt/format.h>
#include <pcl/PolygonMesh.h>
#include <pcl/console/print.h>
#include <pcl/conversions.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include <cstring>
#include <unordered_map>

#include "base/errors.h"
#include "io/mesh_builder.h"
#include "io/mesh_file.h"
#include "io/ply_header.h"

namespace armature {
namespace {

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

std::uint32_t Packed(const ColourBytes& colour) {
  return static_cast<std::uint32_t>(colour[0]) << 16 | static_cast<std::uint32_t>(colour[1]) << 8 | colour[2];
}

// PCL's colours are those of vertices: each vertex once for each colour of its triangles.
pcl::PolygonMesh MakePolygons(const TriangleMesh& mesh) {
  pcl::PointCloud<pcl::PointXYZRGB> cloud;
  pcl::PolygonMesh polygons;
  std::unordered_map<std::uint64_t, pcl::index_t> coloured;
  const bool has_colours = mesh.colours.cols() == mesh.size();
  for (Eigen::Index i = 0; i < mesh.size(); ++i) {
    const ColourBytes colour = has_colours ? ColourBytes(mesh.colours.col(i)) : ColourBytes(160, 160, 160);
    pcl::Vertices& corners = polygons.polygons.emplace_back();
    for (const int v : mesh.triangles.col(i)) {
      const std::uint64_t key = static_cast<std::uint64_t>(v) << 24 | Packed(colour);
      const auto [entry, is_new] = coloured.try_emplace(key, static_cast<pcl::index_t>(cloud.size()));
      if (is_new) {
        const Eigen::Vector3f p = mesh.vertices.col(v).cast<float>();
        cloud.emplace_back(p.x(), p.y(), p.z(), colour[0], colour[1], colour[2]);
      }
      corners.vertices.push_back(entry->second);
    }
  }
  pcl::toPCLPointCloud2(cloud, polygons.cloud);
  return polygons;
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

void WritePly(const TriangleMesh& mesh, const std::filesystem::path& file) {
  SilencePcl();
  std::filesystem::path aside = file;
  aside += ".partial";
  bool is_written = false;
  std::error_code failed;
  try {
    is_written = pcl::io::savePLYFileBinary(aside.string(), MakePolygons(mesh)) == 0;
  } catch (const pcl::IOException&) {
  }
  if (is_written) std::filesystem::rename(aside, file, failed);
  if (is_written && !failed) return;
  std::filesystem::remove(aside, failed);
  throw std::runtime_error(
      fmt::format("{}: cannot be written; does its folder exist and may it be written to?", file.string()));
}

}  // namespace armature
