// SPDX-License-Identifier: BSD-3-Clause
// The CAD models that `armature generate` writes: DIR/cad of its output.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "eval/cad_library.h"

namespace armature {

// instances.csv: `id,category,held_out,size_x,size_y,size_z,mesh`; sizes in metres, held_out 0 or 1. The
// edges of an instance are in CATEGORY_edges.csv, CATEGORY_edges_held_out.csv for those held out, in format
// `edges` of io/annotations.h: metres, object frame. By instance name, "armature:ID"; none when the folder
// has no instances.csv; categories without specification are left out. Throws InputError: a malformed file,
// an instance without edges, an id twice.
std::map<std::string, CadModel> ReadGeneratedCad(const std::filesystem::path& folder,
                                                 const std::vector<CategorySpec>& specs);

}  // namespace armature
