// SPDX-License-Identifier: BSD-3-Clause
// How sure the map is of an object.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "mapping/map_graph.h"

namespace armature {

// Of (rotation, translation, size): rotation and translation along the world's axes, R = exp(w) R_est and t =
// t_est + v, size along the object's own; radians and metres.
using PoseAndSizeCovariance = Eigen::Matrix<double, 9, 9>;

struct ObjectUncertainty {
  double probability = 0;            // that an object of the category is there, see object_evidence.h
  PoseAndSizeCovariance covariance;  // if it is; about the first camera, which is where it is by definition
};

// From the covariance of the object's unknowns as the graph has it (GraphUncertainty), widened by what the
// graph does not know of: lines that are matched to the wrong edges, views of something else, furniture
// unlike its category. The less probable the object, the more of that there is.
PoseAndSizeCovariance CovarianceOfPoseAndSize(const GraphObject& object, const Eigen::MatrixXd& of_unknowns,
                                              double probability);

// The same for the standard deviation of the scale's logarithm, with the probabilities of all objects of the
// map; at least one.
double WidenScaleSigma(double of_graph, const std::vector<double>& probabilities);

}  // namespace armature
