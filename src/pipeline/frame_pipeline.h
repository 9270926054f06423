// SPDX-License-Identifier: BSD-3-Clause
// The front end: one function a frame, in the paper's order.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "category/category_model.h"
#include "geometry/camera.h"
#include "lines/line_detector.h"
#include "mapping/object_map.h"
#include "pipeline/frame_result.h"
#include "pipeline/options.h"
#include "tracking/floor_height.h"
#include "tracking/object_tracks.h"
#include "tracking/odometry_jumps.h"
#include "tracking/up_direction.h"

namespace armature {

// What is known of a frame besides its image.
struct FrameInput {
  double timestamp = 0;
  std::vector<Detection> detections;               // boxes in pixels of the image as it is, distorted
  std::optional<Eigen::Isometry3d> T_odom_camera;  // odometry, any scale
};

// The lines of one frame.
struct DetectedLines {
  std::vector<Segment> segments;  // undistorted pixels, longest first
  double milliseconds = 0;        // that finding them took
};

// One detection of a frame on its way through the pipeline.
struct ObjectInFrame {
  ObjectView view;
  int track = kNoTrack;     // id of the track that it continues; in the end only where it was learnt from
  SingleViewResult result;  // of association and resection
};

// Views and maps point into it, so it stays where it is; maps keep the models alive that their objects are
// of.
class FramePipeline {
 public:
  // `up_odom`: the up direction in the odometry's frame, where the sequence gives one. `odometry_is_metric`:
  // its unit is the metre; otherwise the objects tell its scale.
  FramePipeline(Options options, Camera camera, std::vector<CategoryModel> categories,
                std::optional<Eigen::Vector3d> up_odom, bool odometry_is_metric = false,
                std::optional<FloorPrior> camera_height = std::nullopt);
  FramePipeline(const FramePipeline&) = delete;
  FramePipeline& operator=(const FramePipeline&) = delete;

  // `gray`: 8 bit, one channel, of the camera's size. Throws InputError for a detection of a category without
  // a model.
  FrameResult Process(const cv::Mat& gray, const FrameInput& input);

  // The same in two steps, so that lines of the next frame can be found while this one goes on. The first
  // touches nothing of the pipeline but its detector: it may run in a thread of its own, beside the second.
  DetectedLines DetectLines(const cv::Mat& gray, const std::vector<Detection>& detections);
  FrameResult Process(DetectedLines lines, const FrameInput& input);

  // Of the odometry, as the objects seen so far tell.
  ScaleEstimate OdometryScale() const { return tracks_.Scale(); }

  // The map after the last frame; without odometry there is none, and it stays empty.
  const Map& CurrentMap() const { return map_.current(); }

  struct FinalMaps {
    Map map;
    Map by_odometry;            // the same objects placed by the odometry alone
    double incremental_ms = 0;  // spent on the map while frames came in
    double solve_ms = 0;        // spent on `map`
  };
  // The batch solution of all frames; none without odometry.
  std::optional<FinalMaps> SolveMaps() const;

 private:
  struct PreparedInput : FrameInput {  // positions from the first camera on, jumps taken out
    bool follows_jump = false, unit_changed = false;
  };
  PreparedInput Prepare(const FrameInput& given);
  std::vector<ObjectView> ViewBoxes(const std::vector<Detection>& detections) const;
  std::vector<ObjectInFrame> Predict(const FrameInput& input, FrameResult& frame);
  void Update(const FrameInput& input, std::vector<ObjectInFrame>& objects);
  void AddToMap(const FrameInput& input, const FrameResult& frame, std::vector<ObjectInFrame> objects);

  UpEstimate PredictUp(const FrameInput& input, const std::vector<Segment>& segments);
  void UpdateUp(const std::vector<ObjectInFrame>& objects);
  std::optional<double> ClimbSinceLastFrame(const FrameInput& input, const UpEstimate& up);

  Options options_;
  Camera camera_;
  std::vector<std::shared_ptr<const CategoryModel>> categories_;
  std::optional<Eigen::Vector3d> up_odom_;
  std::optional<FloorPrior> camera_height_;
  std::unique_ptr<LineDetector> detector_;
  UpEstimator up_estimator_;
  FloorHeight floor_;
  OdometryJumps jumps_;
  ObjectTracks tracks_;
  ObjectMap map_;
  double map_milliseconds_ = 0;                 // spent on it so far
  std::optional<Eigen::Vector3d> origin_odom_;  // the first camera's position
  std::optional<Eigen::Isometry3d> last_T_odom_camera_;
};

}  // namespace armature
