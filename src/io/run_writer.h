// SPDX-License-Identifier: BSD-3-Clause
// Writes a run folder (the output of `armature run`) frame by frame. The same results give the same bytes,
// apart from timings.csv and summary.json.
#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "io/run_folder.h"
#include "io/run_summary.h"
#include "io/trajectory.h"
#include "mapping/solve_map.h"
#include "pipeline/frame_result.h"

namespace armature {

// All functions but the constructor throw std::runtime_error when a file cannot be written.
class RunWriter {
 public:
  // Starts the run's clock and the files beside `folder`, see RunFolder for what may be replaced (InputError
  // otherwise). `models`: of all categories that occur, for the names of their edges.
  RunWriter(const std::filesystem::path& folder, std::vector<CategoryModel> models);

  void WriteConfig(const std::string& yaml);  // config.yaml
  // trajectory.txt and objects.csv of the map, odometry_scaled.txt and objects_odometry.csv of the same
  // objects placed by odometry alone, and which object each observation is of.
  void WriteMaps(const Map& map, const Map& by_odometry);
  // Rows of observations.csv, associations.csv and timings.csv.
  void AddFrame(const FrameResult& frame);
  // An image that could not be read: it has no rows and is listed in the summary.
  void AddSkippedImage(double timestamp, const std::string& reason);
  // Where other files of the run can be added until it is finished.
  const std::filesystem::path& partial() const { return folder_.partial(); }
  // Writes summary.json and puts the folder in place. Nothing may be added afterwards.
  void Finish(const RunSummary& summary);

  const RunCounts& counts() const { return counts_; }
  const StageStatistics& statistics() const { return statistics_; }

 private:
  std::filesystem::path File(const std::string& name) const { return folder_.partial() / name; }
  void AddObservation(double timestamp, size_t index, const ObjectObservation& observation);
  void WriteAssociations(double timestamp, size_t index, const ObjectObservation& observation);
  void WriteTimings(const FrameResult& frame);

  // A row of observations.csv; which object it is of is known once the map is.
  struct ObservationRow {
    double timestamp = 0;
    size_t index = 0;
    std::string before_object, object, after_object;
  };
  void WriteObservations();

  RunFolder folder_;
  std::vector<CategoryModel> models_;
  std::vector<ObservationRow> observations_;
  std::ofstream associations_, timings_;
  RunCounts counts_;
  StageStatistics statistics_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace armature
