// SPDX-License-Identifier: BSD-3-Clause
// What the lines of one image say about one object: its pose, its shape and how sure both are.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string_view>
#include <vector>

#include "association/edge_match.h"
#include "resection/resection_solver.h"

namespace armature {

enum class EstimateStatus {
  kOk,
  kTooFewEdges,   // fewer matched edges than determine a pose
  kBehindCamera,  // part of the object would be behind the camera
  kDiverged,      // the optimisation did not reach a finite, plausible pose
  kOffTheBox,     // the estimate's projection is not where the detection is
  kRepeated,      // not looked at: the detection repeats another of its frame
};

// "ok", "too_few_edges", "behind_camera", "diverged", "off_the_box", "repeated"
std::string_view StatusName(EstimateStatus status);

struct ObjectEstimate {
  EstimateStatus status = EstimateStatus::kTooFewEdges;
  Eigen::Isometry3d T_camera_object = Eigen::Isometry3d::Identity();  // metres
  Eigen::VectorXd coefficients;                                       // shape, standard deviations
  // Of the pose, after marginalising over the shape. Order: rotation (radians), then translation (metres),
  // both in the camera frame: R = exp(w) R_est, t = t_est + v.
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  std::vector<EdgeMatch> matches;
  double cost =
      0;  // the association's cost of this estimate, smaller is better, see association/hypothesis_cost.h
  double rms_pixels = 0;                         // of the matched segments' ends from their projected edges
  int iterations = 0;                            // of the optimiser, all rounds of the winning hypothesis
  StopReason stop = StopReason::kMaxIterations;  // of its last round
  bool ambiguous =
      false;  // another, clearly different turn explains the lines equally well; the prior decided
  // That the pose is right: turned by less than 15 degrees and shifted by less than 15 % of its distance
  // against the true one. None where there is no pose, or the association's cost does not tell.
  std::optional<double> probability;
};

}  // namespace armature
