// SPDX-License-Identifier: BSD-3-Clause
// Bringing annotated models into one frame and unit, as PCA over "aligned ordered CAD models" (paper 3.2)
// needs them.
#pragma once

#include <Eigen/Core>

#include "category/category_model.h"

namespace armature {

// Centre of the wireframe's bounding box, in its frame and unit.
Eigen::Vector3d BoundingBoxCenter(const Wireframe& wireframe);

// The reference's measure of the wireframe, in the wireframe's unit.
double Measure(const MetricReference& reference, const Wireframe& wireframe);

// The wireframe moved so that its bounding box is centred at the origin.
Wireframe Centred(const Wireframe& wireframe);

// The wireframe (any unit, any origin, axes of the object frame) in metres, centred: Measure(result) =
// reference.metres. Throws InputError when the reference measures nothing (a seat on the ground, edges
// without length).
Wireframe Normalised(const MetricReference& reference, const Wireframe& wireframe);

// The mirror image in x. Edges swap with the edge whose name has `left` and `right` exchanged; an edge
// without such a partner crosses the mirror's plane and is turned round, so that it still starts at its left
// end. Throws InputError when a name has `left` or `right` in it and its partner does not exist.
Wireframe Mirrored(const CategorySpec& spec, const Wireframe& wireframe);

}  // namespace armature
