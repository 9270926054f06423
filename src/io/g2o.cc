// SPDX-License-Identifier: BSD-3-Clause
#include "io/g2o.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <unordered_map>
#include <unordered_set>

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

constexpr double kQuaternionTolerance = 0.02;  // of its length: written with two digits
constexpr size_t kPoseNumbers = 7, kInformationNumbers = 21;
const std::string kVertex = "VERTEX_SE3:QUAT", kEdge = "EDGE_SE3:QUAT", kFix = "FIX";

// Kinds of lines that are left out, by the start of their tag, and what a reader should know of them.
struct LeftOut {
  const char* tag;
  const char* what;
};
constexpr LeftOut kLeftOut[] = {{"PARAMS_", "parameters of sensors"},
                                {"EDGE_SE3_PRIOR", "priors of single poses do not act"},
                                {"EDGE_SE3_OFFSET", "edges between sensors with offsets do not act"},
                                {"EDGE_SE3_TRACKXYZ", "observations of landmarks do not act"},
                                {"EDGE_SE3_XYZ", "observations of landmarks do not act"},
                                {"EDGE_SE3_PLANE", "observations of planes do not act"},
                                {"EDGE_PLANE", "edges between planes do not act"},
                                {"EDGE_POINTXYZ", "edges between points do not act"},
                                {"VERTEX_TRACKXYZ", "landmarks stay where they are"},
                                {"VERTEX_POINTXYZ", "points stay where they are"},
                                {"VERTEX_PLANE", "planes stay where they are"},
                                {"VERTEX_SE2", "poses in two dimensions stay where they are"},
                                {"VERTEX_XY", "points in two dimensions stay where they are"},
                                {"EDGE_SE2", "edges in two dimensions do not act"},
                                {"EDGE_XY", "edges in two dimensions do not act"},
                                {"EDGE_PRIOR_SE2", "priors of single poses do not act"},
                                {"EDGE_BEARING_SE2", "edges in two dimensions do not act"},
                                {"EDGE_RANGE", "distances do not act"},
                                {"DATA_", "data of sensors"},
                                {"ROBOTLASER", "data of sensors"}};

const LeftOut* FindLeftOut(const std::string& tag) {
  for (const LeftOut& kind : kLeftOut) {
    if (tag.starts_with(kind.tag)) return &kind;
  }
  return nullptr;
}

struct Row {
  int line = 0;
  std::string where;                // "file:line"
  std::vector<std::string> fields;  // tag first
};

struct VertexEntry {
  size_t index = 0;
  std::string where;
};

Row SplitRow(const std::filesystem::path& file, const TextLine& line) {
  return {line.number, fmt::format("{}:{}", file.string(), line.number), SplitWords(line.text)};
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

// The number as it is written again: of 64 bits, as GTSAM's keys are, signed or not.
std::string ParseId(const std::string& text, const std::string& where) {
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto read = [&](auto number) -> std::optional<std::string> {
    const auto [rest, error] = std::from_chars(begin, end, number);
    if (error != std::errc() || rest != end) return std::nullopt;
    return fmt::format("{}", number);
  };
  if (const auto id = read(std::int64_t{})) return *id;
  if (const auto id = read(std::uint64_t{})) return *id;
  return fmt::format("{}", ParseInteger(text, where));
}

double IsotropicWeight(const Eigen::Matrix3d& block) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(block).eigenvalues().cwiseMax(0).mean();
}

Matrix6d Isotropic(const Matrix6d& information) {
  Vector6d weights;
  weights.head<3>().setConstant(IsotropicWeight(information.topLeftCorner<3, 3>()));
  weights.tail<3>().setConstant(IsotropicWeight(information.bottomRightCorner<3, 3>()));
  return weights.asDiagonal();
}

// From the translation first to the rotation first.
Matrix6d ParseInformation(const Row& row, size_t first, G2oWeights taken) {
  Matrix6d information;
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) {
      const int a = (i + 3) % 6, b = (j + 3) % 6;
      information(a, b) = information(b, a) = ParseNumber(row.fields[first++], row.where);
    }
  }
  if (taken == G2oWeights::kIsotropic) return Isotropic(information);
  if (!SquareRootInformation(information)) {
    throw InputError(
        fmt::format("{}: the information matrix is not positive semi-definite; write the upper triangle of "
                    "the inverse of a covariance, or take isotropic weights (--weights isotropic)",
                    row.where));
  }
  return information;
}

// Every line of the file in turn; what names vertices is kept until all of them are known.
class G2oReader {
 public:
  G2oReader(std::filesystem::path file, G2oWeights weights) : file_(std::move(file)), weights_(weights) {}

  G2oFile Read() {
    for (const TextLine& line : ReadTextLines(file_)) Add(SplitRow(file_, line), line.text);
    NoteLeftOut();
    if (vertices_.empty())
      throw InputError(fmt::format("{}: has no {}{}; add vertices", file_.string(), kVertex, Others()));
    if (edges_.empty()) throw InputError(fmt::format("{}: has no {}; add edges", file_.string(), kEdge));
    for (const Row& row : edges_) AddEdge(row);
    for (const Row& row : fixed_) AddFixed(row);
    CheckConnected();
    NoteUntied();
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
    } else if (FindLeftOut(tag) != nullptr) {
      LeaveOut(row);
    } else {
      throw InputError(
          fmt::format("{}: {}", row.where, UnknownNameMessage("tag", tag, {kVertex, kEdge, kFix})));
    }
    g2o_.other_lines.push_back(text);
  }

  void LeaveOut(const Row& row) {
    const std::string& tag = row.fields[0];
    if (tag.starts_with("VERTEX") && row.fields.size() > 1) other_vertices_.insert(row.fields[1]);
    for (LeftOutLines& lines : left_out_) {
      if (lines.tag == tag) return static_cast<void>(++lines.count);
    }
    left_out_.push_back({tag, 1, row.line});
  }

  void NoteLeftOut() {
    for (const LeftOutLines& lines : left_out_) {
      g2o_.notes.push_back(fmt::format("{}: {} {} of {} left out, the first in line {}: {}", file_.string(),
                                       lines.count, lines.count == 1 ? "line" : "lines", lines.tag,
                                       lines.first, FindLeftOut(lines.tag)->what));
    }
  }

  // ", but VERTEX_SE2": what the file is of instead.
  std::string Others() const {
    std::string others;
    for (const LeftOutLines& lines : left_out_) {
      if (lines.tag.starts_with("VERTEX")) others += (others.empty() ? ", but " : ", ") + lines.tag;
    }
    return others;
  }

  // Poses that no edge with information leads to: the solver leaves them at their start, whatever that is.
  void NoteUntied() {
    std::vector<bool> is_tied(g2o_.ids.size(), false);
    for (const PoseGraphEdge& edge : g2o_.graph.edges) {
      if (edge.information.isZero(0)) continue;
      is_tied[edge.from] = is_tied[edge.to] = true;
    }
    for (const size_t fixed : FixedPoses(g2o_.graph)) is_tied[fixed] = true;
    const auto untied = std::count(is_tied.begin(), is_tied.end(), false);
    if (untied == 0) return;
    const auto first = std::find(is_tied.begin(), is_tied.end(), false) - is_tied.begin();
    const std::string& id = g2o_.ids[static_cast<size_t>(first)];
    g2o_.notes.push_back(fmt::format(
        "{}: {} {} tied by edges of zero information alone, the first is vertex {}: nothing measures where "
        "{}",
        vertices_.at(id).where, untied, untied == 1 ? "vertex is" : "vertices are", id,
        untied == 1 ? "it is" : "they are"));
  }

  void AddVertex(const Row& row) {
    CheckFieldCount(row, 1 + kPoseNumbers, "id x y z qx qy qz qw");
    const std::string id = ParseId(row.fields[1], row.where);
    const auto [entry, is_new] = vertices_.try_emplace(id, VertexEntry{g2o_.ids.size(), row.where});
    if (!is_new) {
      throw InputError(
          fmt::format("{}: vertex {} is already in {}; keep one", row.where, id, entry->second.where));
    }
    g2o_.ids.push_back(id);
    g2o_.graph.poses.push_back(ParsePose(row, 2));
  }

  size_t FindIndex(const std::string& id, const Row& row) const {
    const auto entry = vertices_.find(ParseId(id, row.where));
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
    g2o_.graph.edges.push_back(
        {from, to, ParsePose(row, 3), ParseInformation(row, 3 + kPoseNumbers, weights_)});
  }

  void AddFixed(const Row& row) {
    if (row.fields.size() == 1)
      throw InputError(fmt::format("{}: FIX without a vertex; name one", row.where));
    for (size_t i = 1; i < row.fields.size(); ++i) {
      if (!other_vertices_.contains(row.fields[i])) g2o_.graph.fixed.push_back(FindIndex(row.fields[i], row));
    }
  }

  void CheckConnected() const {
    const auto pose = FirstUnconnectedPose(g2o_.graph);
    if (!pose) return;
    const std::string &id = g2o_.ids[*pose], &fixed = g2o_.ids[FixedPoses(g2o_.graph).front()];
    throw InputError(
        fmt::format("{}: no chain of edges connects vertex {} to vertex {}, which is held; add an "
                    "edge or remove the vertex",
                    vertices_.at(id).where, id, fixed));
  }

  struct LeftOutLines {
    std::string tag;
    long count = 0;
    int first = 0;  // line
  };

  std::filesystem::path file_;
  G2oWeights weights_;
  G2oFile g2o_;
  std::unordered_map<std::string, VertexEntry> vertices_;  // by id
  std::unordered_set<std::string> other_vertices_;         // ids of those that are left out
  std::vector<LeftOutLines> left_out_;                     // a kind each
  std::vector<Row> edges_, fixed_;
};

std::string VertexLine(const std::string& id, const Eigen::Isometry3d& pose) {
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

G2oFile ReadG2o(const std::filesystem::path& file, G2oWeights weights) {
  return G2oReader(file, weights).Read();
}

void WriteG2o(const std::filesystem::path& file, const G2oFile& g2o,
              const std::vector<Eigen::Isometry3d>& poses) {
  std::string text;
  for (size_t i = 0; i < poses.size(); ++i) text += VertexLine(g2o.ids[i], poses[i]) + "\n";
  for (const std::string& line : g2o.other_lines) text += line + "\n";
  AtomicWrite(file, text);
}

}  // namespace armature
