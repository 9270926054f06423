// SPDX-License-Identifier: BSD-3-Clause
// Small files of meshes, and what they have to be read as.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/mesh_file.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature::testing {

// The corners of a unit square in order around it, a line a corner.
inline const std::string kSquareVertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

inline double AreaOf(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles.colwise()) {
    const Eigen::Vector3d a = mesh.vertices.col(t[0]);
    area += (mesh.vertices.col(t[1]) - a).cross(mesh.vertices.col(t[2]) - a).norm() / 2;
  }
  return area;
}

inline void ExpectUnitSquare(const TriangleMesh& mesh) {
  EXPECT_EQ(mesh.vertices.cols(), 4);
  EXPECT_EQ(mesh.size(), 2);
  EXPECT_NEAR(AreaOf(mesh), 1, 1e-7);
  EXPECT_EQ(mesh.vertices.col(2), Eigen::Vector3d(1, 1, 0));
}

class MeshFiles : public ::testing::Test {
 protected:
  TriangleMesh Read(const std::string& name, const std::string& content) const {
    return ReadMesh(folder_.Write(name, content));
  }
  void ExpectRefused(const std::string& name, const std::string& content,
                     const std::vector<std::string>& texts) const {
    std::vector<std::string> all = texts;
    all.push_back(name);
    ExpectInputError([&] { Read(name, content); }, all);
  }

  TempFolder folder_;
};

}  // namespace armature::testing
