// SPDX-License-Identifier: BSD-3-Clause
// Bringing an estimated trajectory into the frame of the true one before they are compared.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "eval/trajectories/pose_pairs.h"
#include "io/evaluation_records.h"

namespace armature {

// x_truth = scale * R * x_estimate + t.
struct Similarity {
  double scale = 1;                                 // metres per unit of the estimate
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  // a rotation
  Eigen::Vector3d t{0, 0, 0};                       // metres
  // The pairs do not determine all that the alignment asks for; see Align for what stands in.
  bool is_degenerate = false;

  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return scale * (R * point) + t; }
  // The pose of x in the true world: its origin moved as a point, its axes turned, lengths in its own frame
  // kept.
  Eigen::Isometry3d Apply(const Eigen::Isometry3d& T_world_x) const;
};

// Pairs by growing stamps. `first_n`: of kFirstN alone, at least 1; more than there are means all. Always
// finite; where the pairs leave something open, is_degenerate is set and
//   no pair: the identity;
//   se3, sim3, scale, first_n, and one of the trajectories stays where it is (one pair, or turning in place):
//     scale 1, the rotation that brings the cameras' own rotations nearest to the true ones, the mean
//     position on the true mean;
//   the same, positions on a line: of the rotations that bring line to line, the one that brings the cameras'
//     rotations nearest to the true ones;
//   end_points, and the first and last position of one of the trajectories are equal: scale 1.
Similarity Align(const std::vector<PosePair>& pairs, AlignmentKind kind, int first_n);

// Whether the true camera moves enough for its path to have a scale: 5 cm from the mean of its positions
// (rms).
bool Moves(const std::vector<PosePair>& pairs);

// Metres per unit of the estimate, as kSim3 has it; none where one of the trajectories stays where it is.
std::optional<double> PathScale(const std::vector<PosePair>& pairs);

}  // namespace armature
