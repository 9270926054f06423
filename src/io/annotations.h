// SPDX-License-Identifier: BSD-3-Clause
// Reading annotated CAD models: the edges of many objects of a category.
//
// Formats, chosen by name:
//   edges                a row an edge: `model,edge,x1,y1,z1,x2,y2,z2`, start and end in the object frame's
//   axes (y up,
//                        front +z), any unit and origin. Every model has every edge of the specification
//                        once.
//   keypointnet_chair    a row a model with key points s0..s20 (KeypointNet's numbers); rows with sane = 1
//   shapeassembly_table  a row a model with top corners t0..t3, leg tops lt0..3, leg bottoms lb0..3; without
//   duplicates modelnet_laptop      a row a model with k1,k2 lid top, k3,k4 hinge, k5,k6 front of the base
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "category/category_model.h"

namespace armature {

// One annotated model: axes of the object frame, but the unit and the origin of the file it comes from, so
// that it still fits the CAD model. Normalised() of category/normalise.h brings it to metres.
struct AnnotatedModel {
  std::string id;
  Wireframe wireframe;
};

// The names of the formats.
std::vector<std::string> AnnotationFormats();

// The models in the order of the file, edges in the order of the specification. Throws InputError naming file
// and line: unknown format, missing columns, missing, repeated, unknown or zero-length edges, no model at
// all.
std::vector<AnnotatedModel> ReadAnnotations(const std::filesystem::path& file, const std::string& format,
                                            const CategorySpec& spec);

}  // namespace armature
