// SPDX-License-Identifier: BSD-3-Clause
// Writes a generated sequence as a sequence folder with its ground truth (datasets/README.md).
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "association/detection.h"
#include "geometry/camera.h"
#include "io/run_folder.h"

namespace armature {

struct GeneratedObject {
  std::string id, category, instance;
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();  // metres
  Eigen::Vector3d size{0, 0, 0};                                     // metres
};

struct GeneratedDetection {
  Detection detection;
  std::string id;  // of the object
};

struct GeneratedFrame {
  double timestamp = 0;  // seconds
  cv::Mat image;         // 8-bit BGR
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_odom_camera = Eigen::Isometry3d::Identity();
  std::vector<GeneratedDetection> detections;
};

// The folder is complete or absent.
class SequenceFolder {
 public:
  // Throws InputError when something is at `folder` already, or it cannot be created.
  explicit SequenceFolder(const std::filesystem::path& folder);

  // Writes the image at once. Throws when it cannot be written, as Finish.
  void AddFrame(const GeneratedFrame& frame);

  // Writes the tables and puts the folder in place. `about`: one line, what this sequence is.
  void Finish(const std::string& name, double fps, const Camera& camera,
              const std::vector<GeneratedObject>& objects, const std::string& about);

 private:
  void Write(const std::string& name, const std::string& content) const;

  RunFolder folder_;
  int frames_ = 0;
  std::string images_, detections_, true_detections_, odometry_, groundtruth_;  // contents of the tables
};

}  // namespace armature
