// SPDX-License-Identifier: BSD-3-Clause
#include "io/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "base/errors.h"
#include "base/text.h"

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

}  // namespace

void CheckPlyHeader(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file) || !std::ifstream(file)) {
    throw InputError(
        fmt::format("{}: cannot be opened; check that it exists and may be read", file.string()));
  }
  HeaderReader(file).Check();
}

}  // namespace armature
