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

// How the information matrices of the edges are taken.
enum class G2oWeights {
  kFull,      // as they are
  kIsotropic  // two numbers, for rotation and translation: each the mean of its block's eigenvalues, those
              // below zero as 0; also of matrices that are no inverse of a covariance
};

struct G2oFile {
  PoseGraph graph;                       // poses in the order of the file
  std::vector<std::string> ids;          // of the poses: whole numbers of up to 64 bits
  std::vector<std::string> other_lines;  // all but the poses, as they were read
  std::vector<std::string> notes;        // what was left out, and what no measurement ties
};

// Lines of other kinds that g2o knows (parameters, priors, landmarks, two dimensions) are left out, with a
// note a kind. Throws InputError when the file cannot be read, a line is malformed or of an unknown kind, an
// edge or FIX names a vertex that the file does not have, a vertex stands there twice, an information matrix
// is not positive semi-definite (weights that are full), there is no vertex or no edge, or the edges do not
// connect all vertices.
G2oFile ReadG2o(const std::filesystem::path& file, G2oWeights weights = G2oWeights::kFull);

// The same file with these poses: numbers that read back as the same, edges as they were read. Written aside
// and renamed. Throws InputError when it cannot be written.
void WriteG2o(const std::filesystem::path& file, const G2oFile& g2o,
              const std::vector<Eigen::Isometry3d>& poses);

}  // namespace armature
