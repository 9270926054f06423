// SPDX-License-Identifier: BSD-3-Clause
// The tables of a generated sequence folder, with its ground truth (datasets/README.md).
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "datasets/simulation/detections.h"
#include "datasets/simulation/true_edges.h"
#include "geometry/camera.h"

namespace armature {

struct GeneratedObject {
  std::string id, category, instance;
  Eigen::Isometry3d T_world_object = Eigen::Isometry3d::Identity();  // metres
  Eigen::Vector3d size{0, 0, 0};                                     // metres
};

struct GeneratedFrame {
  double timestamp = 0;  // seconds
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  std::optional<Eigen::Isometry3d> T_odom_camera;  // none: the odometry is lost, or there is none
  std::vector<SimulatedDetection> detections;
  std::vector<std::vector<TrueEdge>> edges;  // of each object
  std::vector<Segment> segments;             // where there are no pictures
};

struct GeneratedSequence {
  std::string name;
  std::string about;  // one line
  double fps = 0;
  Camera camera;
  std::optional<Eigen::Vector3d> up_odom;  // told to the pipeline; none: it has to find out
  bool lines_only = false;                 // there are no pictures
  std::vector<GeneratedObject> objects;
  std::vector<GeneratedFrame> frames;
};

// The image of a frame, from 0: "rgb/0007.jpg".
std::string ImageName(int frame);

// Writes everything but the images; no odometry.txt where no frame has a pose of it. Throws
// std::runtime_error when a file cannot be written.
void WriteSequenceTables(const std::filesystem::path& folder, const GeneratedSequence& sequence);

}  // namespace armature
