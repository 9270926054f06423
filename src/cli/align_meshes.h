// SPDX-License-Identifier: BSD-3-Clause
// Meshes that were published in another frame than their annotations (ModelNet40's laptops).
#pragma once

#include <filesystem>
#include <vector>

#include "category/cad_model.h"
#include "geometry/triangle_mesh.h"

namespace armature {

// For a mesh with z up, turned about it by a multiple of 90 degrees, whose annotations are of the mesh
// centred and scaled to a bounding box of diagonal 1: the turn for which the ends of the annotated edges lie
// nearest to the surface, on average.
Eigen::Affine3d AlignedToAnnotations(const TriangleMesh& mesh, const Wireframe& wireframe);

// Fills T_annotation_geometry in where a model has a surface without it. Throws InputError: a malformed mesh.
void AlignMeshes(const std::filesystem::path& folder, std::vector<CadModel>& models);

}  // namespace armature
