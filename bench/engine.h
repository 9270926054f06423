// SPDX-License-Identifier: BSD-3-Clause
// An engine finds the objects of one frame after the other and says how long each of its stages took: our
// pipeline, or a baseline that it is compared with.
#pragma once

#include <Eigen/Core>
#include <array>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/camera.h"
#include "pipeline/frame_pipeline.h"
#include "resection/object_estimate.h"

namespace armature {

// A frame as an engine gets it: loaded and gray before any clock starts.
struct BenchFrame {
  cv::Mat gray;      // 8 bit, one channel, as it is (distorted)
  FrameInput input;  // boxes in pixels of `gray`
};

struct BenchSequence {
  std::string name;
  Camera camera;
  std::optional<Eigen::Vector3d> up_odom;  // unit, where the sequence gives one
  bool odometry_metric = false;
  std::vector<BenchFrame> frames;
  std::optional<FloorPrior> camera_height{};  // above the floor, where it is known
};

// The stages that engines are compared by.
enum class BenchStage {
  kDetection,     // lines of the whole frame, or the network's forward passes, one an object
  kAssociation,   // hypotheses and matches, or keypoints from heat maps
  kOptimization,  // pose and shape
  kMapping,       // what is kept between frames, and the map
};
inline constexpr size_t kBenchStages = 4;
inline constexpr std::array<std::string_view, kBenchStages> kBenchStageNames = {"detection", "association",
                                                                                "optimization", "mapping"};

// What became of one frame.
struct FrameOutcome {
  std::array<std::optional<double>, kBenchStages>
      stages_ms;                          // wall clock; none: the engine has no such stage
  double added_ms = 0;                    // part of the stages that is counted but was not waited for
  int objects = 0;                        // detections in the frame
  int segments = 0;                       // line segments found; 0 where there are none to find
  std::vector<ObjectEstimate> estimates;  // one a detection; empty: the engine estimates nothing

  std::optional<double>& stage(BenchStage s) { return stages_ms[static_cast<size_t>(s)]; }
  const std::optional<double>& stage(BenchStage s) const { return stages_ms[static_cast<size_t>(s)]; }
};

class Engine {
 public:
  virtual ~Engine() = default;
  // What it is and what its spans include, for the lines under a table.
  virtual std::string Description() const = 0;
  // Whether frames may be left out: nothing is remembered from frame to frame.
  virtual bool IsStateless() const = 0;
  // Forgets everything and gets ready for the frames of the sequence, which outlives the engine's use of it.
  virtual void Start(const BenchSequence& sequence) = 0;
  // One frame; its time is taken from outside as well.
  virtual FrameOutcome Process(const BenchFrame& frame) = 0;
};

}  // namespace armature
