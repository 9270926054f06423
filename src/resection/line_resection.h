// SPDX-License-Identifier: BSD-3-Clause
// Resection (paper 3.4): the pose and shape that fit matched lines, the detection's box, the up direction,
// the floor and the category's shape statistics best.
#pragma once

#include <Eigen/Geometry>

#include "association/box_constraints.h"
#include "association/object_view.h"
#include "resection/object_estimate.h"
#include "resection/resection_problem.h"
#include "resection/resection_solver.h"

namespace armature {

enum class ResectionMode {
  kJoint,        // pose and shape together
  kAlternating,  // the paper's turns
};

template <>
struct EnumNames<ResectionMode> {
  static constexpr NamedValue<ResectionMode> kTable[] = {{ResectionMode::kJoint, "joint"},
                                                         {ResectionMode::kAlternating, "alternating"}};
};

enum class ResectionSolver {
  kSmall,  // our own, of fixed size
  kCeres,  // the reference, ceres::TinySolver
};

template <>
struct EnumNames<ResectionSolver> {
  static constexpr NamedValue<ResectionSolver> kTable[] = {{ResectionSolver::kSmall, "small"},
                                                           {ResectionSolver::kCeres, "ceres"}};
};

// What keeps an edge on its segment.
enum class LineTerm {
  kImage,   // the segment's ends lie on the edge's projection: pixels, robust, by length
  kPlanes,  // the paper's eq. 19: the edge lies in the plane of the segment and the camera; metres, plain
            // squares, of the same weight as the normal term (eq. 24), none of them by length
};

template <>
struct EnumNames<LineTerm> {
  static constexpr NamedValue<LineTerm> kTable[] = {{LineTerm::kImage, "image"},
                                                    {LineTerm::kPlanes, "planes"}};
};

struct ResectionOptions {
  ResectionMode mode = ResectionMode::kJoint;
  ResectionSolver solver = ResectionSolver::kSmall;  // of mode kJoint; kAlternating always has kCeres
  LineTerm line_term = LineTerm::kImage;
  NormalTerm normal_term = NormalTerm::kAxis;
  int max_iterations = 5;       // of the optimiser, each round
  int alternations = 5;         // of mode kAlternating
  double segment_sigma = 2.0;   // pixels: standard deviation of a segment's end from its edge
  double leg_end_sigma = 1;     // of where a leg's segments end, in segment_sigma; 0: not used. Only
                                // EvidenceAt uses it
  double box_weight = 1.0;      // multiplies the box's residuals; 0: none
  double box_loss_scale = 3.0;  // standard deviations; the map's refinement begins with more
  double up_sigma_deg = 1.5;    // degrees: of the up direction
  double shape_weight = 0.7;    // multiplies the coefficients in the regulariser
};

// Standard deviations, of the Geman-McClure loss on segments; tuned on office_dev and redkitchen_a.
inline constexpr double kSegmentLossScale = 3;

// What resection looks at: the matches of one view about a pose and shape. It lives no longer than what it
// refers to.
struct ResectionInput {
  const ObjectView& view;
  const BoxSides& sides;
  const std::vector<EdgeMatch>& matches;
  const ProjectedWireframe& projected;  // of `at`
  const PoseAndShape& at;
  const BoxOptions& box;
  const ResectionOptions& options;
};

struct ResectionResult {
  PoseAndShape estimate;
  double cost = 0;  // half the squared norm of the robust, whitened residuals
  int iterations = 0;
  StopReason stop = StopReason::kMaxIterations;  // alternating: of the last half turn

  bool finite() const { return stop != StopReason::kNotFinite; }
};

// The minimum of any such problem, from its own pose and the given shape, by the options' mode and solver.
ResectionResult ResectFrom(ResectionProblem& problem, const Eigen::VectorXd& coefficients,
                           const ResectionOptions& options);

// One round, from `at`: matches and the box's extreme points stay as they are there. Eq. 16, or 24 and 25 by
// turns.
ResectionResult Resect(const ResectionInput& input);

// Covariance of the pose (see ObjectEstimate) at the estimate, shape marginalised.
Eigen::Matrix<double, 6, 6> PoseCovariance(const ResectionInput& input);

// What one image says about pose and shape, for filters over many images.
struct Measurement {
  PoseAndShape estimate;  // the optimum
  Eigen::MatrixXd
      covariance;  // of (rotation, translation, coefficients), (6+B) x (6+B), as ObjectEstimate::covariance
  // The category's shape statistics are part of it with this information on each coefficient. A filter has to
  // take them out of each measurement and put them in once: or a length that no image shows becomes surer
  // with every image.
  double shape_prior_information = 0;
};
Measurement MeasurementAt(const ResectionInput& optimum);

// The cost of this image's lines and box alone (no up, floor, track prior or shape statistics) about a pose
// and shape, to second order: 1/2 d^T information d + gradient^T d with d = (rotation, translation,
// coefficients), 6 + B numbers, the rotation and translation as of ObjectEstimate::covariance. With line term
// planes the estimate itself is what was measured, as in eq. 28: up is part of it, and the gradient is 0.
struct ImageEvidence {
  Eigen::MatrixXd information;  // (6+B) x (6+B), of Gauss and Newton: positive semi-definite
  Eigen::VectorXd gradient;     // 6+B
};
ImageEvidence EvidenceAt(const ResectionInput& input);

}  // namespace armature
