// SPDX-License-Identifier: BSD-3-Clause
// Pose graphs in g2o's text format, three dimensions:
//   VERTEX_SE3:QUAT id x y z qx qy qz qw
//   EDGE_SE3:QUAT from to x y z qx qy qz qw and the 21 numbers of the upper triangle of the information
//   matrix FIX id...
// The information matrix stands there with the translation first; in memory the rotation is first (se3.h).
// Its numbers are taken as information on r = Log(...), as they are: g2o itself applies them to the vector
// part of the quaternion, which is half the rotation vector.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mapping/pose_graph.h"

namespace armature {

struct G2oFile {
  PoseGraph graph;                       // poses in the order of the file
  std::vector<int> ids;                  // of the poses
  std::vector<std::string> other_lines;  // edges and fixed vertices, as they were read
};

// Throws InputError when the file cannot be read, a line is malformed, an edge or FIX names a vertex that the
// file does not have, a vertex stands there twice, an information matrix is not positive semi-definite, there
// is no vertex or no edge, or the edges do not connect all vertices.
G2oFile ReadG2o(const std::filesystem::path& file);

// The same file with these poses: numbers that read back as the same, edges as they were read. Written aside
// and renamed. Throws InputError when it cannot be written.
void WriteG2o(const std::filesystem::path& file, const G2oFile& g2o,
              const std::vector<Eigen::Isometry3d>& poses);

}  // namespace armature
