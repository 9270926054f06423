// SPDX-License-Identifier: BSD-3-Clause
// A sequence folder: the input of a run. Files: sequence.yaml, rgb.txt, detections.csv and, optionally,
// odometry.txt and segments.csv. Ground truth is never read here.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "association/detection.h"
#include "association/object_view.h"
#include "geometry/camera.h"
#include "geometry/segment.h"
#include "io/trajectory.h"
#include "odometry/odometry.h"

namespace armature {

// What sequence.yaml says.
struct SequenceSettings {
  std::string name;  // a plain word that can name a folder
  double fps = 0;    // images a second
  Camera camera;
  std::optional<Eigen::Vector3d> up;        // unit, up in the frame of the odometry
  bool odometry_metric = false;             // the odometry is in metres; its scale is unknown otherwise
  std::optional<FloorPrior> camera_height;  // above the floor, the same in all images
};

struct ImageEntry {
  double timestamp = 0;        // seconds
  std::filesystem::path file;  // empty: there is no picture, segments.csv has its lines
  int line = 0;                // of rgb.txt
};

struct Sequence {
  std::string name;
  double fps = 0;
  Camera camera;
  std::optional<Eigen::Vector3d> up;  // unit, frame of the odometry
  bool odometry_metric = false;
  std::optional<FloorPrior> camera_height;  // above the floor
  std::filesystem::path folder;
  std::filesystem::path detections_file{};         // instead of its own detections.csv; empty: that
  std::vector<ImageEntry> images;                  // by growing stamps, at least one
  std::vector<std::vector<Detection>> detections;  // per image, in the order of the file; angles in radians
  // Per image, undistorted pixels, longest first, instead of those that a detector would find; empty: there
  // is no segments.csv.
  std::vector<std::vector<Segment>> segments;
  // Per image: where the odometry has its stamp, or neighbours near enough to interpolate between.
  std::vector<std::optional<Eigen::Isometry3d>> T_odom_camera;
  std::vector<TimedPose> odometry;  // the whole file; empty when there is none
  OdometryCoverage coverage;        // of the images by the odometry
};

// Reads the folder. Throws InputError naming file, line and remedy for a missing or malformed file, an
// unknown key, column or category, a listed image that does not exist or has neither picture nor lines,
// stamps that do not grow, a detection without image, a box outside its image, a score outside 0..1, or an
// odometry that gives no image a pose. `detections`: a file to be read instead of the folder's
// detections.csv; empty: that. odometry.txt may be in the TUM or EuRoC format, or in KITTI's with one line an
// image. `categories`: names of the known category models.
Sequence LoadSequence(const std::filesystem::path& folder, const std::vector<std::string>& categories,
                      const OdometryOptions& odometry = {}, const std::filesystem::path& detections = {});

// The sequence of a rendered scene's n-th draw: "seq1", "seq1-draw2", "seq1-draw3", ...
std::string NameDraw(const std::string& scene, int draw);

// The parts of LoadSequence.
SequenceSettings ReadSequenceSettings(const std::filesystem::path& file);
std::vector<ImageEntry> ReadImageList(
    const std::filesystem::path& file);  // image files relative to the list's folder
// Per image; `images` by growing stamps.
std::vector<std::vector<Detection>> ReadDetections(const std::filesystem::path& file,
                                                   const std::vector<ImageEntry>& images,
                                                   const Camera& camera,
                                                   const std::vector<std::string>& categories);

}  // namespace armature
