// SPDX-License-Identifier: BSD-3-Clause
// Writes a run folder (the output of `armature run`) frame by frame. The same results give the same bytes,
// apart from timings.csv and summary.json.
#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "mapping/object_map.h"
#include "category/category_model.h"
#include "io/run_folder.h"
#include "io/run_summary.h"
#include "io/trajectory.h"
#include "pipeline/frame_result.h"

namespace armature {

// All functions but the constructor throw std::runtime_error when a file cannot be written.
class RunWriter {
 public:
  // Starts the run's clock and the files beside `folder`, see RunFolder for what may be replaced (InputError
  // otherwise). `models`: of all categories that occur, for the names of their edges.
  RunWriter(const std::filesystem::path& folder, std::vector<CategoryModel> models);

  void WriteConfig(const std::string& yaml);  // config.yaml
  // trajectory.txt (T_world_camera) and odometry_scaled.txt (the odometry alone, same frame and scale).
  void WriteTrajectories(const std::vector<TimedPose>& trajectory,
                         const std::vector<TimedPose>& odometry_scaled);
  void WriteObjects(const std::string& file, const std::vector<MapObject>& objects);
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
  void WriteObservation(double timestamp, size_t index, const ObjectObservation& observation);
  void WriteAssociations(double timestamp, size_t index, const ObjectObservation& observation);
  void WriteTimings(const FrameResult& frame);

  RunFolder folder_;
  std::vector<CategoryModel> models_;
  std::ofstream observations_, associations_, timings_;
  RunCounts counts_;
  StageStatistics statistics_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace armature
