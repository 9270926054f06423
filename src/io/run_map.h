// SPDX-License-Identifier: BSD-3-Clause
// The map of a finished run, back from its files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "io/run_results.h"
#include "io/sequence.h"
#include "mapping/solve_map.h"
#include "pipeline/options.h"
#include "retrieval/sightings.h"

namespace armature {

// With trajectory.txt, objects.csv and shape_evidence.csv of its folder. A run
// without map gives one without cameras. Throws InputError: a missing or malformed file, a category without
// model, a shape of more coefficients than its category's model has.
Map ReadRunMap(const RunResults& run, const std::vector<CategoryModel>& models);

// The options that the run had (config.yaml). Throws InputError: missing, malformed.
Options ReadRunOptions(const std::filesystem::path& run);

// What was detected in the images of these cameras, with the lines found anew. The sequence has to be the one
// of the map. Throws InputError: an image that cannot be read, a camera of the map without image in the
// sequence.
ViewsOfCameras MakeViews(const Map& map, const std::vector<size_t>& cameras, const Sequence& sequence,
                         const std::vector<CategoryModel>& models, const Options& options);

}  // namespace armature
