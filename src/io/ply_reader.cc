// SPDX-License-Identifier: BSD-3-Clause
#include "io/ply_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/errors.h"
#include "base/text.h"
#include "io/mesh_builder.h"
#include "io/ply_header.h"

namespace armature {
namespace {

constexpr double kLargestIndex = 9e15;  // whole numbers up to it are doubles

// The values of the data one after the other.
class PlyValues {
 public:
  PlyValues(std::string_view content, const PlyHeader& header, const std::filesystem::path& file)
      : rest_(content.substr(header.bytes)), format_(header.format), line_(header.lines + 1), file_(file) {}

  double Next(const PlyScalar& type) {
    return format_ == PlyFormat::kText ? NextWord() : FromBytes(TakeBytes(type.bytes), type);
  }

  // Numbers of one type that nobody needs.
  void Skip(std::uint64_t count, const PlyScalar& type) {
    if (format_ == PlyFormat::kText) {
      for (std::uint64_t i = 0; i < count; ++i) TakeWord();
    } else {
      CheckLeft(count, type.bytes);
      TakeBytes(static_cast<size_t>(count) * type.bytes);
    }
  }

  // How long a list is.
  size_t NextCount(const PlyScalar& type) {
    const double count = Next(type);
    if (!(count >= 0) || count != std::floor(count) || count > kLargestIndex)
      Refuse(fmt::format("is cut short or malformed: a list of {} values", count));
    CheckLeft(static_cast<std::uint64_t>(count), 1);
    return static_cast<size_t>(count);
  }

  std::int64_t NextIndex(const PlyScalar& type) {
    const double index = Next(type);
    if (std::abs(index) <= kLargestIndex && index == std::floor(index))
      return static_cast<std::int64_t>(index);
    Refuse(fmt::format("a face has a corner at vertex {}", index));
  }

  int line() const { return format_ == PlyFormat::kText ? line_ : 0; }

 private:
  [[noreturn]] void Refuse(const std::string& why) const {
    const std::string where = line() == 0 ? file_.string() : fmt::format("{}:{}", file_.string(), line_);
    throw InputError(fmt::format("{}: {}; copy or write it again", where, why));
  }

  // A value has a byte at least, in text with the blank behind it nearly two.
  void CheckLeft(std::uint64_t count, size_t bytes) const {
    if (count > rest_.size() / bytes) Refuse("is cut short or malformed");
  }

  std::string_view TakeBytes(size_t bytes) {
    CheckLeft(bytes, 1);
    const std::string_view taken = rest_.substr(0, bytes);
    rest_.remove_prefix(bytes);
    return taken;
  }

  std::string_view TakeWord() {
    constexpr std::string_view kBlanks = " \t\r\v\f\n";
    size_t begin = 0;
    for (; begin < rest_.size() && kBlanks.find(rest_[begin]) != std::string_view::npos; ++begin) {
      const bool is_pair = rest_[begin] == '\r' && rest_.substr(begin + 1).starts_with('\n');
      line_ += rest_[begin] == '\n' || (rest_[begin] == '\r' && !is_pair) ? 1 : 0;
    }
    rest_.remove_prefix(begin);
    if (rest_.empty()) Refuse("is cut short or malformed");
    return TakeBytes(std::min(rest_.find_first_of(kBlanks), rest_.size()));
  }

  double NextWord() {
    const std::string word(TakeWord());
    return ParseNumber(word, fmt::format("{}:{}", file_.string(), line_));
  }

  double FromBytes(std::string_view bytes, const PlyScalar& type) const {
    std::uint64_t bits = 0;  // most significant byte first
    for (size_t i = 0; i < bytes.size(); ++i) {
      const size_t place = format_ == PlyFormat::kBigEndian ? i : bytes.size() - 1 - i;
      bits = bits << 8 | static_cast<unsigned char>(bytes[place]);
    }
    switch (type.kind) {
      case PlyScalar::Kind::kReal:
        if (type.bytes == 8) return std::bit_cast<double>(bits);
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
      case PlyScalar::Kind::kUnsigned:
        return static_cast<double>(bits);
      case PlyScalar::Kind::kSigned:
        break;
    }
    const size_t unused = 64 - 8 * type.bytes;
    return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
  }

  std::string_view rest_;
  PlyFormat format_;
  int line_;
  const std::filesystem::path& file_;
};

void SkipProperty(const PlyProperty& property, PlyValues& values) {
  values.Skip(property.count ? values.NextCount(*property.count) : 1, property.type);
}

void SkipElement(const PlyElement& element, PlyValues& values) {
  if (element.properties.empty()) return;  // then nothing stands for it, whatever its number
  for (std::uint64_t i = 0; i < element.count; ++i) {
    for (const PlyProperty& property : element.properties) SkipProperty(property, values);
  }
}

struct PlyPolygon {
  std::vector<std::int64_t> corners;
  int line = 0;
};

class PlySurface {
 public:
  PlySurface(const PlyHeader& header, size_t bytes, const std::filesystem::path& file)
      : file_(file), mesh_(file) {
    for (const char* needed : {"vertex", "face"}) FindElement(header, needed);
    for (const PlyElement& element : header.elements) CheckSize(element, bytes);
    CheckCoordinates(FindElement(header, "vertex"));
    corners_ = FindCorners(FindElement(header, "face"));
  }

  void Read(const PlyElement& element, PlyValues& values) {
    if (element.name == "vertex") return ReadVertices(element, values);
    if (element.name == "face") return ReadFaces(element, values);
    SkipElement(element, values);
  }

  // Faces may stand before the vertices that they name.
  TriangleMesh Build() {
    for (const PlyPolygon& polygon : polygons_) mesh_.AddPolygon(polygon.corners, polygon.line);
    return mesh_.Build();
  }

 private:
  [[noreturn]] void Refuse(const std::string& why) const {
    throw InputError(fmt::format("{}: {}", file_.string(), why));
  }

  const PlyElement& FindElement(const PlyHeader& header, const char* name) const {
    for (const PlyElement& element : header.elements) {
      if (element.name == name) return element;
    }
    Refuse(fmt::format("has no element '{}'; give a surface", name));
  }

  void CheckSize(const PlyElement& element, size_t bytes) const {
    if (element.properties.empty() || element.count <= bytes) return;
    Refuse(fmt::format("says {} of element {}, but has only {} bytes; copy it again", element.count,
                       Quoted(element.name), bytes));
  }

  void CheckCoordinates(const PlyElement& vertex) {
    for (const char* name : {"x", "y", "z"}) {
      const auto property = vertex.Find(name);
      if (!property || vertex.properties[*property].count)
        Refuse("its vertices need x, y and z, a number each; write 'property float x'");
    }
  }

  size_t FindCorners(const PlyElement& face) const {
    for (const char* name : {"vertex_indices", "vertex_index"}) {
      const auto property = face.Find(name);
      if (property && face.properties[*property].count) return *property;
    }
    Refuse("its faces need their corners; write 'property list uchar int vertex_indices'");
  }

  void ReadVertices(const PlyElement& vertex, PlyValues& values) {
    for (std::uint64_t i = 0; i < vertex.count; ++i) {
      Eigen::Vector3d position;
      for (const PlyProperty& property : vertex.properties) {
        const size_t axis = std::string_view("xyz").find(property.name);
        if (property.name.size() == 1 && axis != std::string_view::npos) {
          position[static_cast<Eigen::Index>(axis)] = values.Next(property.type);
        } else {
          SkipProperty(property, values);
        }
      }
      mesh_.AddVertex(position, values.line());
    }
  }

  void ReadFaces(const PlyElement& face, PlyValues& values) {
    for (std::uint64_t i = 0; i < face.count; ++i) {
      PlyPolygon polygon;
      for (size_t p = 0; p < face.properties.size(); ++p) {
        const PlyProperty& property = face.properties[p];
        if (p != corners_) {
          SkipProperty(property, values);
          continue;
        }
        polygon.corners.resize(values.NextCount(*property.count));
        for (std::int64_t& corner : polygon.corners) corner = values.NextIndex(property.type);
        polygon.line = values.line();
      }
      polygons_.push_back(std::move(polygon));
    }
  }

  const std::filesystem::path& file_;
  MeshBuilder mesh_;
  size_t corners_ = 0;  // which property of a face
  std::vector<PlyPolygon> polygons_;
};

}  // namespace

TriangleMesh ReadPly(const std::filesystem::path& file) {
  const std::string content = ReadTextFile(file);
  const PlyHeader header = ReadPlyHeader(content, file);
  PlySurface surface(header, content.size(), file);
  PlyValues values(content, header, file);
  for (const PlyElement& element : header.elements) surface.Read(element, values);
  return surface.Build();
}

}  // namespace armature
