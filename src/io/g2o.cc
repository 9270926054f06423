// SPDX-License-Identifier: BSD-3-Clause
#include "io/g2o.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <sstream>
#include <unordered_map>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "base/number_format.h"
#include "base/text.h"
#include "io/atomic_write.h"
#include "mapping/free_poses.h"
#include "mapping/spanning_tree.h"
#include "mapping/square_root_information.h"

namespace armature {
namespace {

constexpr double kQuaternionTolerance = 1e-3;
constexpr size_t kPoseNumbers = 7, kInformationNumbers = 21;
const std::string kVertex = "VERTEX_SE3:QUAT", kEdge = "EDGE_SE3:QUAT", kFix = "FIX";

struct Row {
  std::string where;                // "file:line"
  std::vector<std::string> fields;  // tag first
};

struct VertexEntry {
  size_t index = 0;
  std::string where;
};

Row SplitRow(const std::filesystem::path& file, const TextLine& line) {
  std::istringstream stream(line.text);
  return {fmt::format("{}:{}", file.string(), line.number),
          {std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()}};
}

void CheckFieldCount(const Row& row, size_t count, const std::string& layout) {
  if (row.fields.size() - 1 == count) return;
  throw InputError(fmt::format("{}: {} has {} fields where {} are needed; write '{} {}'", row.where,
                               row.fields[0], row.fields.size() - 1, count, row.fields[0], layout));
}

Eigen::Isometry3d ParsePose(const Row& row, size_t first) {
  std::array<double, kPoseNumbers> v{};
  for (size_t i = 0; i < v.size(); ++i) v[i] = ParseNumber(row.fields[first + i], row.where);
  const Eigen::Quaterniond rotation(v[6], v[3], v[4], v[5]);
  if (std::abs(rotation.norm() - 1) > kQuaternionTolerance) {
    throw InputError(
        fmt::format("{}: the quaternion has length {:.6g}, not 1; write qx qy qz qw of a unit quaternion",
                    row.where, rotation.norm()));
  }
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = rotation.normalized().toRotationMatrix();
  T.translation() = Eigen::Vector3d(v[0], v[1], v[2]);
  return T;
}

// From the translation first to the rotation first.
Matrix6d ParseInformation(const Row& row, size_t first) {
  Matrix6d information;
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) {
      const int a = (i + 3) % 6, b = (j + 3) % 6;
      information(a, b) = information(b, a) = ParseNumber(row.fields[first++], row.where);
    }
  }
  if (!SquareRootInformation(information)) {
    throw InputError(
        fmt::format("{}: the information matrix is not positive semi-definite; write the upper triangle of "
                    "the inverse of a covariance",
                    row.where));
  }
  return information;
}

// Every line of the file in turn; what names vertices is kept until all of them are known.
class G2oReader {
 public:
  explicit G2oReader(std::filesystem::path file) : file_(std::move(file)) {}

  G2oFile Read() {
    for (const TextLine& line : ReadTextLines(file_)) Add(SplitRow(file_, line), line.text);
    if (vertices_.empty())
      throw InputError(fmt::format("{}: has no {}; add vertices", file_.string(), kVertex));
    if (edges_.empty()) throw InputError(fmt::format("{}: has no {}; add edges", file_.string(), kEdge));
    for (const Row& row : edges_) AddEdge(row);
    for (const Row& row : fixed_) AddFixed(row);
    CheckConnected();
    return std::move(g2o_);
  }

 private:
  void Add(Row row, const std::string& text) {
    const std::string& tag = row.fields[0];
    if (tag == kVertex) return AddVertex(row);
    if (tag == kEdge) {
      edges_.push_back(std::move(row));
    } else if (tag == kFix) {
      fixed_.push_back(std::move(row));
    } else {
      throw InputError(
          fmt::format("{}: {}", row.where, UnknownNameMessage("tag", tag, {kVertex, kEdge, kFix})));
    }
    g2o_.other_lines.push_back(text);
  }

  void AddVertex(const Row& row) {
    CheckFieldCount(row, 1 + kPoseNumbers, "id x y z qx qy qz qw");
    const int id = ParseInteger(row.fields[1], row.where);
    const auto [entry, is_new] = vertices_.try_emplace(id, VertexEntry{g2o_.ids.size(), row.where});
    if (!is_new) {
      throw InputError(
          fmt::format("{}: vertex {} is already in {}; keep one", row.where, id, entry->second.where));
    }
    g2o_.ids.push_back(id);
    g2o_.graph.poses.push_back(ParsePose(row, 2));
  }

  size_t FindIndex(const std::string& id, const Row& row) const {
    const auto entry = vertices_.find(ParseInteger(id, row.where));
    if (entry == vertices_.end()) {
      throw InputError(fmt::format("{}: {} names vertex {}, which the file does not have; add it as {}",
                                   row.where, row.fields[0], id, kVertex));
    }
    return entry->second.index;
  }

  void AddEdge(const Row& row) {
    CheckFieldCount(row, 2 + kPoseNumbers + kInformationNumbers,
                    "from to x y z qx qy qz qw I11 I12 ... I66 (upper triangle)");
    const size_t from = FindIndex(row.fields[1], row), to = FindIndex(row.fields[2], row);
    if (from == to) {
      throw InputError(
          fmt::format("{}: an edge from vertex {} to itself; remove it", row.where, row.fields[1]));
    }
    g2o_.graph.edges.push_back({from, to, ParsePose(row, 3), ParseInformation(row, 3 + kPoseNumbers)});
  }

  void AddFixed(const Row& row) {
    if (row.fields.size() == 1)
      throw InputError(fmt::format("{}: FIX without a vertex; name one", row.where));
    for (size_t i = 1; i < row.fields.size(); ++i) g2o_.graph.fixed.push_back(FindIndex(row.fields[i], row));
  }

  void CheckConnected() const {
    const auto pose = FirstUnconnectedPose(g2o_.graph);
    if (!pose) return;
    const int id = g2o_.ids[*pose], fixed = g2o_.ids[FixedPoses(g2o_.graph).front()];
    throw InputError(
        fmt::format("{}: no chain of edges connects vertex {} to vertex {}, which is held; add an "
                    "edge or remove the vertex",
                    vertices_.at(id).where, id, fixed));
  }

  std::filesystem::path file_;
  G2oFile g2o_;
  std::unordered_map<int, VertexEntry> vertices_;
  std::vector<Row> edges_, fixed_;
};

std::string VertexLine(int id, const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d t = pose.translation();
  const Eigen::Quaterniond q = CanonicalQuaternion(pose.linear());
  std::string line = fmt::format("{} {}", kVertex, id);
  // The shortest text that reads back as the same number; + 0.0 takes the sign off a zero.
  for (const double value : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}) {
    line += fmt::format(" {}", value + 0.0);
  }
  return line;
}

}  // namespace

G2oFile ReadG2o(const std::filesystem::path& file) { return G2oReader(file).Read(); }

void WriteG2o(const std::filesystem::path& file, const G2oFile& g2o,
              const std::vector<Eigen::Isometry3d>& poses) {
  std::string text;
  for (size_t i = 0; i < poses.size(); ++i) text += VertexLine(g2o.ids[i], poses[i]) + "\n";
  for (const std::string& line : g2o.other_lines) text += line + "\n";
  AtomicWrite(file, text);
}

}  // namespace armature
