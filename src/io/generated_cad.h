// SPDX-License-Identifier: BSD-3-Clause
// The CAD models that `armature generate` writes: DIR/cad of its output.
#pragma once

#include <filesystem>
#include <vector>

#include "category/cad_model.h"

namespace armature {

// instances.csv: `id,category,held_out,size_x,size_y,size_z,mesh`; sizes in metres, held_out 0 or 1, the mesh
// relative to the folder. The edges of an instance are in CATEGORY_edges.csv, CATEGORY_edges_held_out.csv for
// those held out, in format `edges` of annotations.h: metres, object frame. Instances are named
// "armature:ID"; in the order of the file; none when the folder has no instances.csv; categories without
// specification are left out. Throws InputError: a malformed file, an instance without edges, an id twice.
std::vector<CadModel> ReadGeneratedCad(const std::filesystem::path& folder,
                                       const std::vector<CategorySpec>& specs);

}  // namespace armature
