// SPDX-License-Identifier: BSD-3-Clause
// What a detection's box says about translation (paper 3.3.1, eqs. 7-9).
//
// The paper divides constants k_x, k_y by the box's width and height. The width depends on the azimuth, boxes
// are cut by the image's border and shrunk by occluders; so we use the corners of the projected hypothesis
// that touch each side: u(P) = u_side is linear in T, f_x (X + T_x) = (u_side - c_x) (Z + T_z), and four
// sides give a 4x3 system.
#pragma once

#include <array>
#include <optional>

#include "association/object_view.h"

namespace armature {

struct BoxOptions {
  double sigma = 0.03;      // share of the box's size: standard deviation of a side
  double sigma_pixels = 2;  // added to it
};

// Open where the image's border cuts the box, seen elsewhere.
BoxSides SidesAtImageBorder(const Box& box, const Camera& camera);

// Probability that something hides the object beyond each side of its box. Another detection's box that goes
// on beyond the side may be of an object in front of it; furniture stands on the floor, so what hides it
// mostly hides its bottom.
std::array<double, 4> HiddenProbabilities(const Box& box, const std::vector<Box>& others);

// Standard deviation in pixels of the box's sides, by the axis it moves along: {left/right, top/bottom}.
std::array<double, 2> SideSigmas(const Box& box, const BoxOptions& options);

// The image region in which a projection can touch the box's seen sides: the image, cut at the open sides.
Box ClipBox(const Box& box, const BoxSides& sides, const Camera& camera);

// For each side (left, top, right, bottom) the edge and the position s on it that reach farthest towards that
// side.
struct ExtremePoint {
  int edge = -1;  // -1: nothing is projected
  double s = 0;
  double pixel = 0;      // u or v
  double inverse_z = 0;  // 1/metres
};
std::array<ExtremePoint, 4> Extremes(const ProjectedWireframe& projected);

// The box around the projection; none where nothing is projected.
std::optional<Box> BoxAround(const ProjectedWireframe& projected);

// The same of an object that nothing hides, cut at the image's border.
std::optional<Box> ExpectedBox(const Camera& camera, const CategoryModel& model, const PoseAndShape& object);

// How well a detection's box fits an expected one, up to 1.3: their intersection over union, and 0.3 of the
// share of the box that is inside, as what is seen may be only a part. None where they have too little in
// common.
std::optional<double> BoxAgreement(const Box& expected, const Box& seen, double least_overlap);

// How far the real object reaches beyond its wireframe along the image's x and y, metres: the extent of an
// ellipsoid with the category's padding as half axes.
Eigen::Vector2d ImagePadding(const CategorySpec& spec, const Eigen::Matrix3d& R_camera_object);

// The paper's eqs. 7-9 from the wireframe's extents seen under R at unit distance.
Eigen::Vector3d PrintedTranslation(const ObjectView& view, const Wireframe& wireframe,
                                   const Eigen::Matrix3d& R);

// The translation under which the projection fits the box best, from the sides that are seen; a weak prior
// keeps the depth near the printed equations' where too few sides are seen to determine it.
Eigen::Vector3d TranslationFromBox(const ObjectView& view, const BoxSides& sides, const Wireframe& wireframe,
                                   const Eigen::Matrix3d& R);

}  // namespace armature
