// SPDX-License-Identifier: BSD-3-Clause
// `armature posegraph` from the file to the file.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/g2o.h"
#include "support/program.h"
#include "support/synthetic_pose_graph.h"

namespace armature {
namespace {

using testing::ExpectBadInput;
using testing::RunOk;
using testing::TempFolder;

std::string EdgeLine(const PoseGraphEdge& edge) {
  const Eigen::Quaterniond q(edge.T_from_to.linear());
  const Eigen::Vector3d t = edge.T_from_to.translation();
  const double w = edge.information(0, 0);
  std::ostringstream line;
  line.precision(17);
  line << "EDGE_SE3:QUAT " << edge.from << ' ' << edge.to << ' ' << t.transpose() << ' '
       << q.coeffs().transpose();
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) line << ' ' << (i == j ? w : 0);
  }
  return line.str();
}

class AppPoseGraph : public ::testing::Test {
 protected:
  AppPoseGraph() : graph_(testing::TorusGraph(6, 12, 0.05)) {
    G2oFile g2o;
    for (size_t i = 0; i < graph_.poses.size(); ++i) g2o.ids.push_back(std::to_string(i));
    for (const PoseGraphEdge& edge : graph_.edges) g2o.other_lines.push_back(EdgeLine(edge));
    WriteG2o(in(), g2o, testing::GarbagePoses(graph_));
  }

  std::filesystem::path in() const { return folder_ / "in.g2o"; }
  std::filesystem::path out() const { return folder_ / "out.g2o"; }

  TempFolder folder_;
  PoseGraph graph_;
};

TEST_F(AppPoseGraph, WritesTheOptimisedGraph) {
  const double optimum = SolvePoseGraph(graph_, {}).final_cost;
  const std::string printed = RunOk({"posegraph", in(), "--out", out()}).out;
  for (const char* text : {"vertices", "72", "144", "chordal", "iterations", "solve [ms]", "out.g2o"}) {
    EXPECT_NE(printed.find(text), std::string::npos) << printed;
  }
  const G2oFile written = ReadG2o(out());
  EXPECT_NEAR(PoseGraphCost(written.graph, written.graph.poses), optimum, 1e-6 * optimum);
  EXPECT_EQ(written.other_lines, ReadG2o(in()).other_lines);
  EXPECT_EQ(testing::AllFiles(folder_.path()), (std::set<std::string>{"in.g2o", "out.g2o"}));
}

TEST_F(AppPoseGraph, PrintsJson) {
  const auto json = nlohmann::json::parse(
      RunOk({"posegraph", in(), "--out", out(), "--init", "odometry", "--max-iterations", "0", "--json"})
          .out);
  EXPECT_EQ(json["vertices"], 72);
  EXPECT_EQ(json["edges"], 144);
  EXPECT_EQ(json["init"], "odometry");
  EXPECT_EQ(json["iterations"], 0);
  EXPECT_EQ(json["converged"], false);
  EXPECT_EQ(json["initial_cost"], json["final_cost"]);
  EXPECT_GE(json["solve_ms"].get<double>(), 0);
  EXPECT_EQ(json["out"], out().string());
}

TEST_F(AppPoseGraph, GivesTheSameBytesAgain) {
  RunOk({"posegraph", in(), "--out", out()});
  RunOk({"posegraph", in(), "--out", folder_ / "again.g2o"});
  EXPECT_EQ(testing::ReadFile(out()), testing::ReadFile(folder_ / "again.g2o"));
}

TEST_F(AppPoseGraph, RefusesBadInput) {
  ExpectBadInput({"posegraph", folder_ / "none.g2o", "--out", out()}, {"none.g2o"});
  ExpectBadInput({"posegraph", in()}, {"--out"});
  ExpectBadInput({"posegraph", in(), "--out", out(), "--init", "cordal"}, {"'cordal'", "'chordal'"});
  ExpectBadInput({"posegraph", in(), "--out", out(), "--max-iterations", "-1"}, {"--max-iterations", "-1"});
  ExpectBadInput({"posegraph", in(), "--out", in() / "out.g2o"}, {"out.g2o"});
  const auto bad = folder_.Write("bad.g2o", "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nEDGE_SE3 0 1\n");
  ExpectBadInput({"posegraph", bad, "--out", out()}, {"bad.g2o:2", "EDGE_SE3:QUAT"});
  ExpectBadInput({"posegraph", in(), "--out", out(), "--loss", "Hubert"}, {"'Hubert'", "'huber'"});
  ExpectBadInput({"posegraph", in(), "--out", out(), "--loss-scale", "0"}, {"--loss-scale", "0"});
  ExpectBadInput({"posegraph", in(), "--out", out(), "--weights", "iso"}, {"'iso'", "isotropic"});
  EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(AppPoseGraph, ALineOfAFormFeedAloneIsBlank) {
  const auto file = folder_.Write("blank.g2o", testing::ReadFile(in()) + "\f\n\v\n");
  RunOk({"posegraph", file, "--out", out()});
}

// A wrong loop closure bends the square's solution and hardly that of a robust loss.
TEST_F(AppPoseGraph, ARobustLossLeavesAsideAWrongEdge) {
  PoseGraphEdge wrong{0, 36};
  wrong.T_from_to.translation() = Eigen::Vector3d(30, -20, 10);
  wrong.information = graph_.edges.front().information;
  const auto file = folder_.Write("wrong.g2o", testing::ReadFile(in()) + EdgeLine(wrong) + "\n");
  RunOk({"posegraph", in(), "--out", out()});
  const std::vector<Eigen::Isometry3d> truth = ReadG2o(out()).graph.poses;
  const auto largest_error = [&](const std::string& loss) {
    RunOk({"posegraph", file, "--out", out(), "--init", "odometry", "--loss", loss});
    const std::vector<Eigen::Isometry3d> poses = ReadG2o(out()).graph.poses;
    double largest = 0;
    for (size_t i = 0; i < poses.size(); ++i)
      largest = std::max(largest, (poses[i].translation() - truth[i].translation()).norm());
    return largest;
  };
  const double square = largest_error("square");
  EXPECT_GT(square, 1);
  EXPECT_LT(largest_error("huber"), square);
  EXPECT_LT(largest_error("cauchy"), 0.02 * square);
}

}  // namespace
}  // namespace armature
