// SPDX-License-Identifier: BSD-3-Clause
// Translations that come from lines instead of the box.
//
// A box that the image cuts on two or three sides, or whose object is half hidden, does not tell where the
// object is. With the rotation given, a segment on an edge does: its plane through the camera, normal N,
// holds the edge,
//   N . (R M + T) = 0   (paper eq. 17),
// one linear equation in T. Two edges and the floor, on which the object's lowest point lies, make three.
#pragma once

#include <vector>

#include "association/object_view.h"

namespace armature {

// Whether the box alone is too little: a side is cut or likely hidden.
bool NeedsLineSeeds(const ObjectView& view);

// Translations under which two edges lie on two segments and the object stands on the floor, those first
// whose pairs are longest. Empty where neither floor nor up is known, or the category does not stand on the
// floor.
std::vector<Eigen::Vector3d> TranslationsFromLines(const ObjectView& view, const Wireframe& wireframe,
                                                   const Eigen::Matrix3d& R);

}  // namespace armature
