// SPDX-License-Identifier: BSD-3-Clause
// The runs of a report, by their sequences, with what their maps are when they are brought to the truth.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "eval/objects/run_objects.h"
#include "eval/report/report_sources.h"
#include "io/sequence.h"

namespace armature {

// One of a run's two maps. World: the true one where there is a truth, else the run's own. Metres.
struct ShownMap {
  Approach approach = Approach::kObjects;
  std::vector<TimedPose> T_world_camera;
  std::vector<PlacedObject> objects;
  std::vector<EvaluatedObject> evaluated;  // matched by distance, as the tables have it; empty: no truth
};

struct LoadedRun {
  std::string name;  // as the tables have it
  RunResults results;
  RunConfiguration configuration;
  std::optional<ShownMap> map, odometry;  // none: without objects
};

struct SequenceRuns {
  std::string name;
  std::optional<SequenceTruth> truth;
  std::optional<Sequence> images;  // none: its folder is gone
  std::vector<LoadedRun> runs;     // in the order given, at least one
  Eigen::Vector3d up{0, -1, 0};    // unit, against gravity: the mean of the true objects' y axes, without
                                   // truth of the first map's; of a level first camera where there is none
};

// By sequence, in the order of their first runs. `remarks` gets a line for what is absent. Throws InputError:
// a malformed file, a run of other category models.
std::vector<SequenceRuns> LoadSequenceRuns(const ReportSources& sources, std::vector<std::string>& remarks);

// The camera at the time; null: there is none within kStampTolerance.
const TimedPose* CameraAt(const ShownMap& map, double timestamp);

}  // namespace armature
