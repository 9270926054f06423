// SPDX-License-Identifier: BSD-3-Clause
// All options of a run: every field's default is here, its key, help and range in OptionTable.
#pragma once

#include <vector>

#include "base/option_entry.h"
#include "lines/line_detector.h"
#include "mapping/solve_map.h"
#include "pipeline/object_estimator.h"
#include "tracking/floor_height.h"
#include "tracking/object_tracks.h"
#include "tracking/up_direction.h"

namespace armature {

struct Options {
  LineOptions lines;
  UpOptions up;
  FloorOptions floor;
  TrackOptions tracks;
  AssociationOptions association;
  ResectionOptions resection;
  MappingOptions mapping;
};

// One row an option; the rows point into `options`.
std::vector<OptionEntry> OptionTable(Options& options);

}  // namespace armature
