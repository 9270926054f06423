// SPDX-License-Identifier: BSD-3-Clause
// From what an image says about an object to a factor of the graph.
#pragma once

#include "mapping/map_frame.h"
#include "mapping/map_graph.h"

namespace armature {

// Errors that the lines' residuals do not tell, alike in neighbouring frames: wrong matches, the wireframe's
// own error. Added to a factor as independent noise of its pose and shape; all greater than 0. The defaults
// are those of single-view estimates, as in tracking; tuned on office_dev and redkitchen_a.
struct FactorNoise {
  double measurement_scale = 2;   // multiplies the standard deviations of resection
  double depth_sigma = 0.08;      // share of the distance, along the ray
  double lateral_sigma = 0.025;   // share of the distance, across the ray
  double rotation_sigma_deg = 4;  // degrees
  double shape_sigma = 0.5;       // standard deviations of the category
};

// The evidence about `at` as a factor, A and b. `turn`: radians about the object's y axis by which the
// factor's pose is turned from `at`, for symmetric objects.
ObjectFactor MakeObjectFactor(const ImageEvidence& evidence, const PoseAndShape& at, double turn,
                              const FactorNoise& noise);

// Leaves it to others how the object is turned: for observations that see its front where its back is.
void MarginalizeRotation(ObjectFactor& factor);

// The residual A d + b with the object seen at the pose and shape.
Eigen::VectorXd Residual(const ObjectFactor& factor, const PoseAndShape& seen);

// The same observation of the object turned about its y axis by the angle, radians: what was its front is
// not.
void Turn(double angle, ObjectFactor& factor);

// How far the camera may be from where the graph has it.
struct DriftNoise {
  double translation_sigma = 0;  // metres
  double rotation_sigma = 0;     // radians
};
ObjectFactor WithDrift(const ObjectFactor& factor, const DriftNoise& drift);

}  // namespace armature
