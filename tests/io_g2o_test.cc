// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>

#include "geometry/rotation.h"
#include "io/g2o.h"
#include "support/expect_input_error.h"
#include "support/program.h"
#include "support/shared_data.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::ExpectInputError;
using testing::TempFolder;

const std::string kVertices =
    "VERTEX_SE3:QUAT 7 1 2 3 0 0 0.70710678 0.70710678\n"
    "VERTEX_SE3:QUAT 3 0 0 0 0 0 0 -1\n";
const std::string kUnitInformation = " 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1";
const std::string kEdge = "EDGE_SE3:QUAT 7 3 4 5 6 0.0 0 0 1" + kUnitInformation + "\n";

void ExpectRefused(const std::string& content, const std::vector<std::string>& texts) {
  const TempFolder folder;
  const auto file = folder.Write("graph.g2o", content);
  ExpectInputError([&] { ReadG2o(file); }, texts);
}

TEST(G2o, ReadsVerticesEdgesAndFixedOnes) {
  const TempFolder folder;
  const G2oFile g2o =
      ReadG2o(folder.Write("graph.g2o", "# a graph\n" + kEdge + "\n" + kVertices + "FIX 3\n"));
  EXPECT_EQ(g2o.ids, (std::vector<std::string>{"7", "3"}));
  ASSERT_EQ(g2o.graph.poses.size(), 2u);
  EXPECT_TRUE((g2o.graph.poses[0] * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(1, 3, 3), 1e-7));
  EXPECT_TRUE(g2o.graph.poses[1].isApprox(Eigen::Isometry3d::Identity(), 1e-12));
  EXPECT_EQ(g2o.graph.fixed, std::vector<size_t>{1});
  ASSERT_EQ(g2o.graph.edges.size(), 1u);
  EXPECT_EQ(g2o.graph.edges[0].from, 0u);
  EXPECT_EQ(g2o.graph.edges[0].to, 1u);
  EXPECT_EQ(g2o.graph.edges[0].T_from_to.translation(), Eigen::Vector3d(4, 5, 6));
}

// In the file x y z come before the rotation; in memory the rotation is first.
TEST(G2o, TurnsTheInformationToRotationFirst) {
  const TempFolder folder;
  const G2oFile g2o = ReadG2o(folder.Write(
      "graph.g2o", kVertices + "EDGE_SE3:QUAT 7 3 0 0 0 0 0 0 1 "
                               "10 1 2 3 .4 .5  20 4 .6 .7 .8  30 .9 .1 .2  40 5 6  50 7  60\n"));
  Matrix6d expected;
  expected << 40, 5, 6, 3, .6, .9,  //
      5, 50, 7, .4, .7, .1,         //
      6, 7, 60, .5, .8, .2,         //
      3, .4, .5, 10, 1, 2,          //
      .6, .7, .8, 1, 20, 4,         //
      .9, .1, .2, 2, 4, 30;
  EXPECT_EQ(g2o.graph.edges[0].information, expected);
}

TEST(G2o, WritesPosesThatReadBackTheSameAndEdgesAsTheyWere) {
  const TempFolder folder;
  const std::string others = kEdge + "FIX 3\n";
  const G2oFile g2o = ReadG2o(folder.Write("in.g2o", others + kVertices));
  Vector6d xi;
  xi << 0.3, -2.8, 0.1, 1.0 / 3, -1e-7, 1e5 / 7;
  const std::vector<Eigen::Isometry3d> poses = {ExpSE3(xi), Eigen::Isometry3d::Identity()};
  WriteG2o(folder / "out.g2o", g2o, poses);
  const G2oFile read = ReadG2o(folder / "out.g2o");
  EXPECT_EQ(read.ids, g2o.ids);
  EXPECT_EQ(read.graph.poses[0].translation(), poses[0].translation());
  EXPECT_TRUE(read.graph.poses[0].isApprox(poses[0], 1e-15));
  const std::string written = testing::ReadFile(folder / "out.g2o");
  EXPECT_TRUE(written.ends_with(others)) << written;
  EXPECT_NE(written.find("VERTEX_SE3:QUAT 3 0 0 0 0 0 0 1\n"), std::string::npos) << written;
  EXPECT_EQ(testing::AllFiles(folder.path()), (std::set<std::string>{"in.g2o", "out.g2o"}));
}

TEST(G2o, LeavesNothingBehindWhereItCannotWrite) {
  const TempFolder folder;
  const G2oFile g2o = ReadG2o(folder.Write("in.g2o", kVertices + kEdge));
  ExpectInputError([&] { WriteG2o(folder / "in.g2o/out.g2o", g2o, g2o.graph.poses); }, {"out.g2o"});
  std::filesystem::create_directory(folder / "taken");
  folder.Write("taken/file", "");
  ExpectInputError([&] { WriteG2o(folder / "taken", g2o, g2o.graph.poses); }, {"taken"});
  EXPECT_EQ(testing::AllFiles(folder.path()), (std::set<std::string>{"in.g2o", "taken", "taken/file"}));
}

TEST(G2o, KeepsIdsOf64Bits) {
  const TempFolder folder;
  std::string text = kVertices + kEdge;
  for (const auto& [from, to] :
       {std::pair{" 7 ", " 8646911284551352320 "}, {" 3 ", " 18446744073709551615 "}}) {
    for (size_t at; (at = text.find(from)) != std::string::npos;) text.replace(at, std::strlen(from), to);
  }
  const G2oFile g2o = ReadG2o(folder.Write("graph.g2o", text + "FIX +8646911284551352320\n"));
  EXPECT_EQ(g2o.ids, (std::vector<std::string>{"8646911284551352320", "18446744073709551615"}));
  EXPECT_EQ(g2o.graph.fixed, std::vector<size_t>{0});
  WriteG2o(folder / "out.g2o", g2o, g2o.graph.poses);
  EXPECT_NE(testing::ReadFile(folder / "out.g2o").find("VERTEX_SE3:QUAT 18446744073709551615 0"),
            std::string::npos);
  ExpectRefused("VERTEX_SE3:QUAT 18446744073709551616 0 0 0 0 0 0 1\n" + kEdge,
                {"graph.g2o:1", "whole number"});
}

TEST(G2o, LeavesOutOtherKindsOfLinesAndSaysSo) {
  const TempFolder folder;
  const std::string others = "PARAMS_SE3OFFSET 0 0 0 0 0 0 0 1\nEDGE_SE3_PRIOR 7 0 0 0 0 0 0 0 1" +
                             kUnitInformation +
                             "\nVERTEX_TRACKXYZ 20 1 2 3\nEDGE_SE3_TRACKXYZ 7 20 0 1 2 3 1 0 0 1 0 1\n"
                             "EDGE_SE3_TRACKXYZ 3 20 0 1 2 3 1 0 0 1 0 1\nFIX 20\n";
  const G2oFile g2o = ReadG2o(folder.Write("graph.g2o", kVertices + others + kEdge));
  EXPECT_TRUE(g2o.graph.fixed.empty());
  ASSERT_EQ(g2o.notes.size(), 4u);
  EXPECT_NE(g2o.notes[0].find("1 line of PARAMS_SE3OFFSET left out, the first in line 3"), std::string::npos)
      << g2o.notes[0];
  EXPECT_NE(g2o.notes[1].find("EDGE_SE3_PRIOR"), std::string::npos);
  EXPECT_NE(g2o.notes[3].find("2 lines of EDGE_SE3_TRACKXYZ"), std::string::npos) << g2o.notes[3];
  WriteG2o(folder / "out.g2o", g2o, g2o.graph.poses);
  EXPECT_TRUE(testing::ReadFile(folder / "out.g2o").ends_with(others + kEdge));
  ExpectRefused("VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 0 0 0\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n",
                {"graph.g2o", "no VERTEX_SE3:QUAT", "VERTEX_SE2"});
}

TEST(G2o, SaysWhichVertexNoInformationTies) {
  const TempFolder folder;
  const std::string zeros = " 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n";
  const std::string third = "VERTEX_SE3:QUAT 9 0 0 0 0 0 0 1\nEDGE_SE3:QUAT 7 9 0 0 0 0 0 0 1";
  const G2oFile g2o = ReadG2o(folder.Write("graph.g2o", kVertices + kEdge + third + zeros));
  ASSERT_EQ(g2o.notes.size(), 1u);
  for (const char* text : {"graph.g2o:4", "zero information", "vertex 9"})
    EXPECT_NE(g2o.notes[0].find(text), std::string::npos) << g2o.notes[0];
  EXPECT_TRUE(ReadG2o(folder.Write("tied.g2o", kVertices + kEdge + third + kUnitInformation)).notes.empty());
}

TEST(G2o, TakesIsotropicWeightsAlsoOfIndefiniteMatrices) {
  const TempFolder folder;
  const auto file = folder.Write("graph.g2o", kVertices +
                                                  "EDGE_SE3:QUAT 7 3 0 0 0 0 0 0 1 "
                                                  "1 0 0 9 9 9  2 0 9 9 9  6 9 9 9  4 8 0  4 0  4\n");
  ExpectInputError([&] { ReadG2o(file); }, {"graph.g2o:3", "--weights isotropic"});
  const Matrix6d information = ReadG2o(file, G2oWeights::kIsotropic).graph.edges[0].information;
  Vector6d expected;
  expected << Eigen::Vector3d::Constant(16.0 / 3), Eigen::Vector3d::Constant(3);  // eigenvalues 12, 4, -4
  EXPECT_TRUE(information.isApprox(Matrix6d(expected.asDiagonal()), 1e-12)) << information;
}

TEST(G2o, RefusesUnknownTags) {
  ExpectRefused(kVertices + kEdge + "VERTEX_SE3:QAUT 1 0 0 0\n",
                {"graph.g2o:4", "'VERTEX_SE3:QAUT'", "VERTEX_SE3:QUAT"});
}

TEST(G2o, RefusesAnotherNumberOfFields) {
  ExpectRefused(kEdge + "VERTEX_SE3:QUAT 1 0 0 0 0 0 1\n",
                {"graph.g2o:2", "has 7 fields", "8", "qx qy qz qw"});
  ExpectRefused(kVertices + "EDGE_SE3:QUAT 7 3 0 0 0 0 0 0 1 1 0\n", {"graph.g2o:3", "has 11 fields", "30"});
  ExpectRefused(kVertices + "EDGE_SE3:QUAT\n", {"graph.g2o:3", "has 0 fields"});
  ExpectRefused(kVertices + kEdge + "FIX\n", {"graph.g2o:4", "FIX"});
}

TEST(G2o, RefusesWhatIsNotAFiniteNumber) {
  ExpectRefused("VERTEX_SE3:QUAT 1 nan 0 0 0 0 0 1\n" + kEdge, {"graph.g2o:1", "'nan'"});
  ExpectRefused("VERTEX_SE3:QUAT 1.5 0 0 0 0 0 0 1\n" + kEdge, {"graph.g2o:1", "'1.5'", "whole number"});
  ExpectRefused(kVertices + "EDGE_SE3:QUAT 7 3 0 0 inf 0 0 0 1" + kUnitInformation, {"graph.g2o:3", "'inf'"});
}

TEST(G2o, RefusesQuaternionsOfAnotherLength) {
  ExpectRefused("VERTEX_SE3:QUAT 1 0 0 0 0 0 0 1.1\n" + kEdge, {"graph.g2o:1", "1.1", "unit quaternion"});
  ExpectRefused(kVertices + "EDGE_SE3:QUAT 7 3 0 0 0 0 0 0 0" + kUnitInformation,
                {"graph.g2o:3", "length 0"});
}

TEST(G2o, RefusesEdgesAndFixOfMissingVertices) {
  ExpectRefused(kVertices + "EDGE_SE3:QUAT 7 4 0 0 0 0 0 0 1" + kUnitInformation,
                {"graph.g2o:3", "vertex 4"});
  ExpectRefused(kVertices + kEdge + "FIX 3 9\n", {"graph.g2o:4", "vertex 9"});
}

TEST(G2o, RefusesAnEdgeToItself) {
  ExpectRefused(kVertices + "EDGE_SE3:QUAT 7 7 0 0 0 0 0 0 1" + kUnitInformation,
                {"graph.g2o:3", "vertex 7"});
}

TEST(G2o, RefusesRepeatedVertices) {
  ExpectRefused(kVertices + "VERTEX_SE3:QUAT 7 0 0 0 0 0 0 1\n" + kEdge,
                {"graph.g2o:3", "vertex 7", "graph.g2o:1"});
}

TEST(G2o, RefusesInformationThatIsNotPositiveSemiDefinite) {
  ExpectRefused(kVertices + "EDGE_SE3:QUAT 7 3 0 0 0 0 0 0 1 1 2 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n",
                {"graph.g2o:3", "positive semi-definite"});
}

TEST(G2o, RefusesFilesWithoutVerticesOrEdges) {
  ExpectRefused("# nothing\n", {"graph.g2o", "VERTEX_SE3:QUAT"});
  ExpectRefused(kVertices, {"graph.g2o", "EDGE_SE3:QUAT"});
}

TEST(G2o, RefusesGraphsThatFallApart) {
  ExpectRefused(kVertices + "VERTEX_SE3:QUAT 12 0 0 0 0 0 0 1\n" + kEdge,
                {"graph.g2o:3", "vertex 12", "vertex 7"});
}

TEST(G2o, ReadsRealGraphs) {
  ARMATURE_SHARED_DATA_OR_SKIP(file, "posegraphs/parking-garage.g2o");
  const PoseGraph graph = ReadG2o(file).graph;
  EXPECT_EQ(graph.poses.size(), 1661u);
  EXPECT_EQ(graph.edges.size(), 6275u);
}

}  // namespace
}  // namespace armature
