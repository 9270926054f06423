// SPDX-License-Identifier: BSD-3-Clause
// A finished run folder, as the evaluation reads it.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/segment.h"

namespace armature {

// A row of associations.csv.
struct RunMatch {
  std::string edge;  // its name in the category's specification
  Segment segment;   // undistorted pixels
};

// A row of observations.csv with its rows of associations.csv.
struct RunObservation {
  double timestamp = 0;                              // seconds
  int index = 0;                                     // the detection's number among those of its timestamp
  std::string status;                                // "ok", or why there is no estimate to rely on
  std::optional<Eigen::Isometry3d> T_camera_object;  // metres; none where the row has no pose
  std::vector<RunMatch> matches;
  std::string object;                   // id in objects.csv of the map object that it is of; empty: of none
  std::vector<double> shape{};          // coefficients, standard deviations; empty: not kept
  std::optional<double> probability{};  // that the pose is right, ObjectEstimate::probability

  bool ok() const { return status == "ok"; }
};

// What a run is of.
struct RunIdentity {
  std::filesystem::path folder;
  std::string sequence;                   // its name
  std::filesystem::path sequence_folder;  // empty: the run did not record it
  std::filesystem::path detections{};     // the file of its detections; empty: the sequence's own
  int jitter = 0;                         // seed of what its input was changed by; 0: nothing
};

struct RunResults {
  std::filesystem::path folder;
  std::string sequence;                   // its name
  std::filesystem::path sequence_folder;  // empty: the run did not record it
  std::filesystem::path detections{};     // the file of its detections; empty: the sequence's own
  std::map<std::pair<long long, int>, RunObservation> observations;  // (whole microseconds, index)

  // The observation of a detection; stamps match within kStampTolerance. Null: the run has no row of it.
  const RunObservation* Find(double timestamp, int index) const;
};

// summary.json of a run folder. Throws InputError: not a finished run.
RunIdentity IdentifyRun(const std::filesystem::path& folder);

// summary.json, observations.csv and associations.csv of a run folder. Throws InputError: not a finished run,
// a missing or malformed file, a repeated observation, an association without its observation, a half-empty
// pose.
RunResults LoadRun(const std::filesystem::path& folder);

// The folder itself where it is a run, else the finished runs directly inside it, by name. Throws InputError
// when there is none.
std::vector<std::filesystem::path> RunsIn(const std::filesystem::path& folder);

}  // namespace armature
