// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstring>

#include "geometry/mesh_shapes.h"
#include "io/mesh_file.h"
#include "io/ply_text.h"
#include "support/expect_input_error.h"
#include "support/mesh_files.h"
#include "support/shared_data.h"

namespace armature {
namespace {

using testing::AreaOf;
using testing::ExpectInputError;
using testing::ExpectUnitSquare;
using testing::kSquareVertices;

using MeshFile = testing::MeshFiles;

std::string PlyHead(const std::string& format, int vertices, int faces, const std::string& real = "float") {
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices) + "\nproperty " + real +
         " x\nproperty " + real + " y\nproperty " + real + " z\nelement face " + std::to_string(faces) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

template <typename T>
std::string Bytes(T value, std::endian order = std::endian::little) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if (order != std::endian::native) bytes.assign(bytes.rbegin(), bytes.rend());
  return bytes;
}

std::string BinarySquare(std::endian order, const std::vector<int>& corners) {
  std::string bytes =
      PlyHead(order == std::endian::little ? "binary_little_endian" : "binary_big_endian", 4, 1);
  for (const float v : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f}) bytes += Bytes(v, order);
  bytes += static_cast<char>(corners.size());
  for (const int corner : corners) bytes += Bytes(corner, order);
  return bytes;
}

TEST_F(MeshFile, PlyIsReadAsTextAndInBothByteOrders) {
  ExpectUnitSquare(Read("a.ply", PlyHead("ascii", 4, 1) + kSquareVertices + "4 0 1 2 3\n"));
  ExpectUnitSquare(Read("a.ply", PlyHead("ascii", 4, 1, "double") + kSquareVertices + "4 0 1 2 3\n"));
  ExpectUnitSquare(Read("a.ply", BinarySquare(std::endian::little, {0, 1, 2, 3})));
  ExpectUnitSquare(Read("a.ply", BinarySquare(std::endian::big, {0, 1, 2, 3})));
}

TEST_F(MeshFile, PlyPropertiesThatAreNotNeededAreLeftOutInSilence) {
  const std::string text =
      "ply\nformat ascii 1.0\ncomment a\nelement vertex 4\nproperty uchar quality\nproperty double x\n"
      "property double y\nproperty double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face 1\nproperty list uchar int vertex_index\nproperty uchar red\nend_header\n"
      "7 0 0 0 1 2 3\n7 1 0 0 1 2 3\n7 1 1 0 1 2 3\n7 0 1 0 1 2 3\n4 0 1 2 3 9\n";
  ::testing::internal::CaptureStderr();
  ExpectUnitSquare(Read("a.ply", text));
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

// Each scalar type at a coordinate, a list's count and a corner; both byte orders.
TEST_F(MeshFile, PlyScalarsMayBeOfAnyType) {
  const auto square = [](const std::string& format, const auto bytes, const char* type) {
    std::string text = std::string("ply\nformat ") + format + " 1.0\nobj_info num_cols 3\nelement vertex 4\n";
    for (const char* name : {"z", "y", "x"}) text += std::string("property ") + type + " " + name + "\n";
    text +=
        std::string("element face 1\nproperty list ") + type + " " + type + " vertex_indices\nend_header\n";
    for (const int value : {0, 0, 0, 0, 0, 1, 0, 1, 1, 0, 1, 0, 4, 0, 1, 2, 3}) text += bytes(value);
    return text;
  };
  const auto read_all = [&](const auto one, const std::vector<const char*>& types) {
    using Scalar = decltype(one);
    for (const char* type : types) {
      for (const auto order : {std::endian::little, std::endian::big}) {
        const auto bytes = [&](int value) {
          return Bytes(static_cast<std::remove_const_t<Scalar>>(value), order);
        };
        const char* format = order == std::endian::little ? "binary_little_endian" : "binary_big_endian";
        ExpectUnitSquare(Read("a.ply", square(format, bytes, type)));
      }
      ExpectUnitSquare(
          Read("a.ply", square(
                            "ascii", [](int value) { return std::to_string(value) + " "; }, type)));
    }
  };
  read_all(std::int8_t{1}, {"char", "int8", "uchar", "uint8"});
  read_all(std::int16_t{1}, {"short", "int16", "ushort", "uint16"});
  read_all(std::int32_t{1}, {"int", "int32", "uint", "uint32"});
  read_all(std::int64_t{1}, {"int64", "uint64"});
  read_all(1.f, {"float", "float32"});
  read_all(1.0, {"double", "float64"});
}

TEST_F(MeshFile, PlyElementsAndPropertiesMayBeInAnyOrder) {
  const std::string text =
      "ply\r\nformat ascii 1.0\r\nelement camera 1\r\nproperty list uchar float k\r\nproperty int n\r\n"
      "element face 1\r\nproperty uchar blue\r\nproperty list uchar short vertex_index\r\n"
      "property list uchar float texcoord\r\nelement empty 1000000000\r\nelement vertex 4\r\n"
      "property uchar blue\r\nproperty float z\r\nproperty list int int more\r\nproperty float y\r\n"
      "property uchar green\r\nproperty float x\r\nproperty uchar red\r\nelement edge 1\r\n"
      "property int vertex1\r\nend_header\r\n"
      "2 0.5 1e-400 7\r\n9 4 0 1 2 3 2 0.5 +0.5\r\n1 0 0 0 2 0 3\r\n1 0 1 8 0 2 1 3\r\n1 0 0 1 2 1 3\r\n"
      "1 0 0 1 2 0 3\r\n0";
  ExpectUnitSquare(Read("a.ply", text));
}

TEST_F(MeshFile, PlyColoursOfTheOrderBlueGreenRedAreNoHarm) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar blue\nproperty uchar green\nproperty uchar red\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n"
      "0 0 0 1 2 3\n1 0 0 1 2 3\n1 1 0 1 2 3\n0 1 0 1 2 3\n4 0 1 2 3\n";
  ExpectUnitSquare(Read("a.ply", text));
  ExpectRefused("a.ply", "ply\nc1mment x\nformat ascii 1.0\nend_header\n",
                {"a.ply:2", "'c1mment'", "'comment'"});
}

TEST_F(MeshFile, ACrInABinaryPlyIsNoEndOfALine) {
  std::string text = BinarySquare(std::endian::little, {0, 1, 2, 3});
  const size_t start = text.find("end_header\n") + 11;
  text.replace(start, 1, "\n");  // the first byte of the first x: a tiny number
  EXPECT_EQ(Read("a.ply", text).size(), 2);
}

TEST_F(MeshFile, PolygonsThatAreNotConvexKeepTheirAreaInEveryFormat) {
  const std::string corners[] = {"0.5 0 0", "0 0 0", "0 0.5 0", "-0.5 0.5 0", "-0.5 -0.5 0", "0.5 -0.5 0"};
  std::string obj, list;
  for (const std::string& corner : corners) {
    obj += "v " + corner + "\n";
    list += corner + "\n";
  }
  EXPECT_NEAR(AreaOf(Read("a.obj", obj + "f 1 2 3 4 5 6\n")), 0.75, 1e-12);
  EXPECT_NEAR(AreaOf(Read("a.off", "OFF\n6 1 0\n" + list + "6 0 1 2 3 4 5\n")), 0.75, 1e-12);
  EXPECT_NEAR(AreaOf(Read("a.ply", PlyHead("ascii", 6, 1) + list + "6 0 1 2 3 4 5\n")), 0.75, 1e-12);
  EXPECT_NEAR(AreaOf(Read("b.obj", obj + "f 6 5 4 3 2 1\n")), 0.75, 1e-12);
}

TEST_F(MeshFile, GeometryMayHaveAHashInItsPath) {
  const std::string square = "OFF\n4 1 0\n" + kSquareVertices + "4 0 1 2 3\n";
  ExpectUnitSquare(ReadGeometry(folder_.Write("c#1/chair#2.off", square)));
  ExpectUnitSquare(ReadGeometry(folder_.Write("c#1/chair.off", square)));
  const auto boxes = folder_.Write("c#1/boxes.txt", "m#1 7 0 0 0 1 2 3 0 1 0 -1 0 0 0 0 1\n");
  EXPECT_EQ(ReadGeometry(boxes.string() + "#m#1").size(), 12);
  EXPECT_TRUE(HasGeometry(boxes.string() + "#7"));
  EXPECT_FALSE(HasGeometry(folder_ / "c#1/none.txt#7"));
  ExpectInputError([&] { ReadGeometry(folder_ / "c#1/none.off"); }, {"c#1/none.off", "cannot be opened"});
}

TEST_F(MeshFile, PlyBadInput) {
  const std::string malformed = "cut short or malformed";
  ExpectRefused("a.ply", "", {"header does not end"});
  ExpectRefused("a.ply", "OFF\n", {"a.ply:1", "start with 'ply'"});
  ExpectRefused("a.ply", "ply\nformat ascii 1.0\nelement vertex 4\n", {"header does not end"});
  ExpectRefused("a.ply", "ply\nformat ascii 1.0\nelement vertex\nend_header\n", {"name and a number"});
  ExpectRefused("a.ply", "ply\nformat ascii 1.0\nelement face 0\nend_header\n", {"no element 'vertex'"});
  ExpectRefused("a.ply", "ply\nformat ascii 1.0\nelement vertex 0\nelement face 0\nend_header\n",
                {"x, y and z"});
  ExpectRefused("a.ply", PlyHead("ascii", 4, 0) + kSquareVertices, {"no face"});
  ExpectRefused("a.ply", PlyHead("ascii", 4, 1) + kSquareVertices, {malformed});
  ExpectRefused("a.ply", PlyHead("ascii", 4, 1) + "0 0 0\n1 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", {"a.ply"});
  ExpectRefused("a.ply", PlyHead("ascii", 4, 1) + kSquareVertices + "4 0 1 2 4\n", {"vertex 4"});
  ExpectRefused("a.ply", PlyHead("ascii", 4, 1) + "0 0 0\n1 0 0\n1 nan 0\n0 1 0\n4 0 1 2 3\n",
                {"a.ply:12", "'nan'"});
  ExpectRefused("a.ply", PlyHead("fantasy", 4, 1) + kSquareVertices + "4 0 1 2 3\n",
                {"a.ply:2", "'fantasy'"});
  const std::string binary = BinarySquare(std::endian::little, {0, 1, 2, 3});
  for (const size_t missing : {1, 4, 17, 40}) {
    ExpectRefused("a.ply", binary.substr(0, binary.size() - missing), {malformed});
  }
  ExpectRefused("a.ply", BinarySquare(std::endian::little, {0, 1, 2, -1}), {"vertex"});
}

TEST_F(MeshFile, PlyThatClaimsMoreThanItHoldsIsRefusedBeforeItTakesMemory) {
  const std::string head = "ply\nformat binary_little_endian 1.0\n";
  const std::string real = "property float x\nproperty float y\nproperty float z\n";
  const std::string list = "property list uint int vertex_indices\nend_header\n";
  ExpectRefused("a.ply", head + "element vertex 4000000000\n" + real + "element face 1\n" + list,
                {"4000000000", "'vertex'", "bytes"});
  ExpectRefused("a.ply", head + "element vertex 0\n" + real + "element face 4000000000\n" + list,
                {"4000000000", "'face'", "bytes"});
  ExpectRefused("a.ply",
                head + "element vertex 1\n" + real + "element vertex 1\n" + real + "element face 1\n" + list,
                {"'vertex'", "twice"});
  ExpectRefused("a.ply", head + "element vertex 1\n" + real + "property float x\nelement face 1\n" + list,
                {"a.ply:7", "'x'", "twice"});
  ExpectRefused("a.ply",
                head + "element vertex 1\n" + real + "element face 1\n" + list + std::string(12, '\0') +
                    Bytes(0xF0000000u) + Bytes(0),
                {"cut short or malformed"});
}

TEST_F(MeshFile, BadNames) {
  ExpectInputError([&] { ReadMesh(folder_ / "none.ply"); }, {"none.ply", "cannot be opened"});
  ExpectInputError([&] { ReadMesh(folder_ / "none.off"); }, {"none.off", "cannot be opened"});
  ExpectInputError([&] { ReadMesh(folder_ / "none.obj"); }, {"none.obj", "cannot be opened"});
  ExpectInputError([&] { ReadMesh(folder_ / "none.stl"); }, {"none.stl", ".ply, .obj or .off"});
  std::filesystem::create_directories(folder_ / "folder.ply");
  ExpectInputError([&] { ReadMesh(folder_ / "folder.ply"); }, {"folder.ply", "is a folder"});
}

// Half size (1, 2, 3), its u axis along y, its v axis along -x.
const std::string kTurnedBox = "m1 7 10 0 0 1 2 3 0 1 0 -1 0 0 0 0 1\n";

TEST_F(MeshFile, BoxesAreFoundByEitherId) {
  const std::filesystem::path file = folder_.Write(
      "boxes.txt", "# ids box\n" + kTurnedBox + "m2 8 0 0 0 1 1 1 1 0 0 0 1 0 0 0 1\n" + kTurnedBox);
  for (const char* id : {"m1", "7"}) {
    const TriangleMesh boxes = ReadGeometry(file.string() + "#" + id);
    EXPECT_EQ(boxes.size(), 24);
    EXPECT_NEAR(AreaOf(boxes), 2 * 2 * (2 * 4 + 2 * 6 + 4 * 6), 1e-9);
    EXPECT_TRUE(boxes.vertices.rowwise().minCoeff().isApprox(Eigen::Vector3d(8, -1, -3)));
    EXPECT_TRUE(boxes.vertices.rowwise().maxCoeff().isApprox(Eigen::Vector3d(12, 1, 3)));
  }
}

TEST_F(MeshFile, BoxesBadInput) {
  const std::filesystem::path file = folder_.Write("boxes.txt", kTurnedBox + "m2 8 1 2 3\n");
  EXPECT_EQ(ReadBoxes(file, "m1").size(), 12);
  ExpectInputError([&] { ReadBoxes(file, "m3"); }, {"boxes.txt", "no box of 'm3'"});
  ExpectInputError([&] { ReadBoxes(file, "m2"); }, {"boxes.txt:2", "15 numbers"});
  ExpectInputError([&] { ReadBoxes(folder_ / "none.txt", "m1"); }, {"none.txt", "cannot be opened"});
  ExpectInputError([&] { ReadBoxes(folder_.Write("b.txt", "m1 7 0 0 0 1 1 1 1 0 0 0 1 0 0 0 x\n"), "m1"); },
                   {"b.txt:1"});
}

TEST_F(MeshFile, WhatIsWrittenIsReadAgain) {
  TriangleMesh mesh;
  Append(BoxMesh({1, 2, 3}, Eigen::Matrix3d::Identity()), {255, 0, 10}, mesh);
  Append(BallMesh({0, 0, 0}, 0.5), {0, 128, 255}, mesh);
  for (const PlyColours colours : {PlyColours::kOfVertices, PlyColours::kOfTriangles}) {
    const TriangleMesh read = Read("a.ply", PlyText(mesh, colours, "two solids"));
    EXPECT_EQ(read.size(), mesh.size());
    EXPECT_EQ(read.vertices.cols(), mesh.vertices.cols());
    EXPECT_NEAR(AreaOf(read), AreaOf(mesh), 1e-5);
  }
}

TEST_F(MeshFile, VerticesBetweenTwoColoursAreWrittenForEach) {
  TriangleMesh mesh{Eigen::Matrix3Xd::Zero(3, 4), Eigen::Matrix3Xi(3, 2), {}};
  mesh.vertices.rightCols<3>().setIdentity();
  mesh.triangles << 0, 1, 1, 2, 2, 3;
  mesh.colours.resize(3, 2);
  mesh.colours << 250, 20, 30, 240, 1, 2;
  const std::string file = PlyText(mesh, PlyColours::kOfVertices, "two colours");
  EXPECT_NE(file.find("element vertex 6\n"), std::string::npos);
  EXPECT_NE(file.find("property uchar red\n"), std::string::npos);
  const std::string body = file.substr(file.find("end_header\n") + 11);
  ASSERT_EQ(body.size(), 6u * 15u + 2u * 13u);
  for (size_t vertex = 0; vertex < 6; ++vertex) {  // three floats and the colour
    EXPECT_EQ(body.substr(15 * vertex + 12, 3), vertex < 3 ? "\xFA\x1E\x01" : "\x14\xF0\x02");
  }
}

TEST(SharedMeshes, LaptopsAndBoxesOfTheSharedDataAreRead) {
  ARMATURE_SHARED_DATA_OR_SKIP(cad, "cad");
  EXPECT_GT(ReadMesh(cad / "modelnet40_laptop" / "laptop_0002.off").size(), 50);
  const std::string boxes = (cad / "keypointnet_chair_boxes.txt").string();
  EXPECT_GE(ReadGeometry(boxes + "#11740d372308f12185047f9f654ddc2e").size(), 5 * 12);
}

}  // namespace
}  // namespace armature
