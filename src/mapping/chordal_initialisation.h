// SPDX-License-Identifier: BSD-3-Clause
// Poses of a pose graph without a start: two linear least-squares problems, each with one solution.
//
// Rotations first. Without the constraint that R_i is a rotation,
//   sum over the edges of kappa |R_j - R_i R_ij|^2 (Frobenius)
// is linear: every row of R_i is an unknown of its own, and the three share one matrix. The solution is
// projected to the nearest rotations (Martinec and Pajdla 2007; Carlone et al., ICRA 2015, "chordal
// relaxation"). For a small error |R_j - R_i R_ij|^2 is 2 |w|^2, so kappa is the mean information on w.
// Then, with the rotations held,
//   sum over the edges of tau |t_j - t_i - R_i t_ij|^2
// is linear in the positions; tau is the mean information on the translation.
//
// It replaces what iterations cannot do: linearised rotations are right only up to a few tens of degrees.
#pragma once

#include "mapping/pose_graph.h"

namespace armature {

// The fixed poses keep their place; no other pose of the graph is looked at. A graph whose edges agree is
// solved exactly. The edges have to connect all poses (spanning_tree.h). Throws std::runtime_error when the
// linear system cannot be solved.
std::vector<Eigen::Isometry3d> ChordalPoses(const PoseGraph& graph);

}  // namespace armature
