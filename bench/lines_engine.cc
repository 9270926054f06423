// SPDX-License-Identifier: BSD-3-Clause
#include "bench/lines_engine.h"

#include <fmt/format.h>

namespace armature {

std::unique_ptr<FramePipeline> MakePipeline(const Options& options, const std::vector<CategoryModel>& models,
                                            const BenchSequence& sequence) {
  return std::make_unique<FramePipeline>(options, sequence.camera, models, sequence.up_odom,
                                         sequence.odometry_metric, sequence.camera_height);
}

LinesEngine::LinesEngine(Options options, std::vector<CategoryModel> models)
    : options_(std::move(options)), models_(std::move(models)) {}

std::string LinesEngine::Description() const {
  const LineOptions& lines = options_.lines;
  const bool is_scaled = lines.detector == LineDetectorKind::kEdgeDrawing && !lines.published;
  return fmt::format(
      "our pipeline, as `armature run` processes a frame, with {} ({} parameters{}) in {}; the map's "
      "solution after the last frame is not part of it",
      ToName(lines.detector), lines.published ? "published" : "tuned",
      is_scaled ? fmt::format(", at {:g} of the image's size", lines.edgedrawing_scale) : "",
      lines.boxes_only ? "the boxes only" : "the whole image");
}

void LinesEngine::Start(const BenchSequence& sequence) {
  pipeline_ = MakePipeline(options_, models_, sequence);
}

FrameOutcome LinesEngine::Process(const BenchFrame& frame) {
  last_ = pipeline_->Process(frame.gray, frame.input);
  FrameOutcome outcome;
  outcome.stage(BenchStage::kDetection) = last_.times.lines;
  outcome.stage(BenchStage::kAssociation) = last_.times.association;
  outcome.stage(BenchStage::kOptimization) = last_.times.optimization;
  outcome.stage(BenchStage::kMapping) = last_.times.mapping;
  outcome.objects = static_cast<int>(last_.observations.size());
  outcome.segments = static_cast<int>(last_.segments.size());
  for (ObjectObservation& observation : last_.observations)
    outcome.estimates.push_back(std::move(observation.estimate));
  return outcome;
}

}  // namespace armature
