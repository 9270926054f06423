// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/mesh_files.h"

namespace armature {
namespace {

using testing::ExpectUnitSquare;
using testing::kSquareVertices;

using TextMesh = testing::MeshFiles;

const std::string kObjVertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(TextMesh, ObjFacesAreReadInEveryForm) {
  for (const char* face : {"f 1 2 3 4", "f 1/1 2/2 3/3 4/4", "f 1//1 2//1 3//1 4//1",
                           "f 1/1/1 2/2/1 3/3/1 4/4/1", "f -4 -3 -2 -1"}) {
    ExpectUnitSquare(Read("a.obj", kObjVertices + face + "\n"));
  }
}

TEST_F(TextMesh, ObjMayHaveMoreNormalsThanVerticesAndWhatIsNotAMesh) {
  std::string text = "mtllib none.mtl\no chair\n" + kObjVertices + "vt 0 0\n";
  for (int i = 0; i < 100; ++i) text += "vn 0 0 1\n";
  ExpectUnitSquare(Read("a.OBJ", text + "usemtl wood\ns off\nf 1//1 2//50 3//99 4//100 # all\n"));
}

TEST_F(TextMesh, ObjLinesMayGoOn) {
  ExpectUnitSquare(Read("a.obj", "v 0 0 0\nv 1 \\\n 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 \\\r\n\\\n 3 \\\n4\n"));
  ExpectUnitSquare(Read("a.obj", kObjVertices + "f 1 2 3 4 \\"));
  ExpectRefused("a.obj", kObjVertices + "f 1 2 \\\n 7\n", {"a.obj:5", "vertex 6"});
}

TEST_F(TextMesh, LinesOfBlanksOfAnyKindAreNothing) {
  ExpectUnitSquare(Read("a.obj", "\f\n" + kObjVertices + "\v\n\f\v\nf 1 2 3 4\f\n"));
  ExpectUnitSquare(Read("a.off", "OFF\n\f\n4 1 0\n" + kSquareVertices + "\v\n4 0 1 2 3\n"));
  ExpectRefused("a.off", "OFF\n\f\n0 0 0\n", {"no face"});
}

TEST_F(TextMesh, OffMayHaveMoreAtItsVerticesAndBreakLinesAnywhere) {
  const auto square = [](const std::string& head, const std::string& more) {
    return head + "\n4 1 0\n0 0 0" + more + "\n1 0 0" + more + "\n1 1 0" + more + "\n0 1 0" + more +
           "\n4 0 1 2 3 0.5 0.5\n";
  };
  ExpectUnitSquare(Read("a.off", square("COFF", " 255 0 0 255")));
  ExpectUnitSquare(Read("a.off", square("COFF", " 0.5 0 0")));
  ExpectUnitSquare(Read("a.off", square("NOFF", " 0 0 1")));
  ExpectUnitSquare(Read("a.off", square("CNOFF", " 1 1 1 1 0 0 1")));
  ExpectUnitSquare(Read("a.off", square("STOFF", " 0.1 0.2")));
  ExpectUnitSquare(Read("a.off", "OFF 4 1 0 0 0 0 1 0 0 1 1 0 0 1 0 4 0 1 2 3"));
  ExpectUnitSquare(Read("a.off", "OFF\n4\n2\n5\n0 0 0 1 0 0\n1 1 0 0\n1 0\n3 0 1 2 3\n0 2 3\n"));
  ExpectUnitSquare(Read("a.off", "NOFF 4 1 4 0 0 0 0 0 1 1 0 0 0 0 1 1 1 0 0 0 1 0 1 0 0 0 1 4 0 1 2 3"));
  ExpectRefused("a.off", "OFF BINARY\n", {"binary"});
  ExpectRefused("a.off", "4OFF\n1 1 0\n", {"three dimensions"});
}

TEST_F(TextMesh, ObjBadInput) {
  ExpectRefused("a.obj", "", {"no face"});
  ExpectRefused("a.obj", kObjVertices, {"no face"});
  ExpectRefused("a.obj", kObjVertices + "f 1 2\n", {"a.obj:5", "2 corners"});
  ExpectRefused("a.obj", kObjVertices + "f 1 2 5\n", {"a.obj:5", "vertex 4", "4 vertices"});
  ExpectRefused("a.obj", kObjVertices + "f 1 2 -5\n", {"a.obj:5", "vertex -1"});
  ExpectRefused("a.obj", kObjVertices + "f 0 1 2\n", {"a.obj:5", "counts from 1"});
  ExpectRefused("a.obj", kObjVertices + "f 1 2 x\n", {"a.obj:5", "'x'"});
  ExpectRefused("a.obj", kObjVertices + "f /1 2 3\n", {"a.obj:5", "''"});
  ExpectRefused("a.obj", "v 0 0\n", {"a.obj:1", "x, y and z"});
  ExpectRefused("a.obj", "v 0 nan 0\n", {"a.obj:1", "'nan'"});
}

TEST_F(TextMesh, OffHeadMayBeGluedToTheCounts) {
  const std::string body = kSquareVertices + "3 0 1 2 255 0 0\n3 0 2 3\n";
  for (const char* head :
       {"OFF\n4 2 0\n", "OFF4 2 0\n", "OFF 4 2\n", "OFF # a square\n\n# counts\n4 2 0\n"}) {
    ExpectUnitSquare(Read("a.off", head + body));
  }
  ExpectUnitSquare(Read("a.off", "OFF\n4 1 0\n" + kSquareVertices + "4 0 1 2 3\n"));
}

TEST_F(TextMesh, OffBadInput) {
  ExpectRefused("a.off", "", {"start with OFF"});
  ExpectRefused("a.off", "ply\n", {"start with OFF"});
  ExpectRefused("a.off", "OFF\n", {"ends after OFF"});
  ExpectRefused("a.off", "OFF\n4\n", {"a.off:2", "numbers of vertices, faces"});
  ExpectRefused("a.off", "OFF\n-4 2 0\n", {"a.off:2"});
  ExpectRefused("a.off", "OFF\n2000000000 2000000000 0\n", {"2000000000", "only 0 numbers"});
  ExpectRefused("a.off", "OFF\n4 1 0\n" + kSquareVertices, {"only 12 numbers"});
  ExpectRefused("a.off", "OFF\n4 1 0\n" + kSquareVertices + "3 0 1 4\n", {"a.off:7", "vertex 4"});
  ExpectRefused("a.off", "OFF\n4 1 0\n" + kSquareVertices + "5 0 1 2 3\n", {"a.off:7", "5 corners"});
  ExpectRefused("a.off", "OFF\n4 1 0\n" + kSquareVertices + "-1 0 1 2\n", {"a.off:7", "-1 corners"});
  ExpectRefused("a.off", "OFF\n1 1 0\n0 inf 0\n3 0 0 0\n", {"a.off:3", "'inf'"});
  ExpectRefused("a.off", "OFF\n1 1 0\n0 0\n3 0 0 0\n", {"a.off:3", "x, y and z"});
}

}  // namespace
}  // namespace armature
