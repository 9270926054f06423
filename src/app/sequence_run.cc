// SPDX-License-Identifier: BSD-3-Clause
#include "app/sequence_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "app/interrupt.h"
#include "io/errors.h"
#include "io/image.h"
#include "io/image_writer.h"
#include "io/overlay.h"
#include "io/progress.h"
#include "io/run_writer.h"
#include "pipeline/frame_pipeline.h"
#include "pipeline/stage_clock.h"

namespace armature {
namespace {

struct LoadedImage {
  ImageResult colour;
  cv::Mat gray;
  double milliseconds = 0;
};

LoadedImage Load(const ImageEntry& entry, const Camera& camera) {
  LoadedImage loaded;
  const StageClock clock(loaded.milliseconds);
  loaded.colour = ReadImage(entry.file, camera);
  if (loaded.colour.image) cv::cvtColor(*loaded.colour.image, loaded.gray, cv::COLOR_BGR2GRAY);
  return loaded;
}

FrameResult ProcessFrame(const Sequence& sequence, size_t index, const LoadedImage& image,
                         FramePipeline& pipeline) {
  const FrameInput input{sequence.images[index].timestamp, sequence.detections[index],
                         sequence.T_odom_camera[index]};
  FrameResult frame = pipeline.Process(image.gray, input);
  frame.times.load = image.milliseconds;
  return frame;
}

void WriteOverlay(const std::filesystem::path& folder, size_t index, const cv::Mat& image,
                  const FrameResult& frame, const std::vector<CategoryModel>& models, const Camera& camera) {
  const cv::Mat overlay = DrawOverlay(Undistorted(image, camera), frame, models, camera);
  WritePicture(folder / "overlays" / fmt::format("{:06}.jpg", index), overlay);
}

void NoteOdometryGaps(const Sequence& sequence) {
  const OdometryCoverage& c = sequence.coverage;
  if (c.poses == 0) return;
  if (c.interpolated > 0) {
    fmt::print(stderr, "armature: {}: {} of {} images take a pose between two of the odometry's\n",
               sequence.name, c.interpolated, c.images);
  }
  if (c.gaps > 0) {
    fmt::print(stderr, "armature: {}: {} of {} images have no odometry; gaps: {}, the longest {:.2f} s\n",
               sequence.name, c.images - c.images_with_pose, c.images, c.gaps, c.longest_gap);
  }
}

// The options for this sequence: odometry in metres has no scale to be found.
Options OptionsFor(const Sequence& sequence, Options options) {
  if (sequence.odometry_metric) options.mapping.scale = "none";
  return options;
}

// Solves the map and writes it; without odometry there is none, and its files are empty.
std::optional<MapSummary> WriteMaps(const FramePipeline& pipeline, RunWriter& writer) {
  const std::optional<FramePipeline::FinalMaps> maps = pipeline.SolveMaps();
  if (!maps) {
    writer.WriteMaps({}, {});
    return std::nullopt;
  }
  writer.WriteMaps(maps->map, maps->by_odometry);
  const Map& map = maps->map;
  return MapSummary{.objects = static_cast<long>(map.objects.size()),
                    .scale = map.MeanScale(),
                    .scale_sigma = map.scale_sigma,
                    .first_scale = std::exp(map.log_scale.front()),
                    .last_scale = std::exp(map.log_scale.back()),
                    .incremental_ms = maps->incremental_ms,
                    .solve_ms = maps->solve_ms};
}

size_t FrameCount(const Sequence& sequence, int limit) {
  if (limit <= 0) return sequence.images.size();
  return std::min(sequence.images.size(), static_cast<size_t>(limit));
}

}  // namespace

SequenceRunResult RunSequence(const Sequence& sequence, const SequenceRunSettings& settings,
                              const std::filesystem::path& folder) {
  RunWriter writer(folder, settings.models);
  writer.WriteConfig(settings.config_yaml);
  FramePipeline pipeline(OptionsFor(sequence, settings.options), sequence.camera, settings.models,
                         sequence.up);
  const size_t count = FrameCount(sequence, settings.frames);
  NoteOdometryGaps(sequence);
  {
    Progress progress(sequence.name + ": frames", static_cast<long>(count));
    for (size_t i = 0; i < count; ++i) {
      ThrowIfInterrupted();
      const LoadedImage image = Load(sequence.images[i], sequence.camera);
      if (!image.colour.image) {
        if (i == 0) throw InputError(image.colour.error);
        fmt::print(stderr, "armature: skipped {}\n", image.colour.error);
        writer.AddSkippedImage(sequence.images[i].timestamp, image.colour.error);
      } else {
        const FrameResult frame = ProcessFrame(sequence, i, image, pipeline);
        writer.AddFrame(frame);
        if (settings.overlays) {
          WriteOverlay(writer.partial(), i, *image.colour.image, frame, settings.models, sequence.camera);
        }
      }
      progress.Step();
    }
  }
  const std::optional<MapSummary> map = WriteMaps(pipeline, writer);
  writer.Finish({.sequence = sequence.name,
                 .sequence_folder = std::filesystem::absolute(sequence.folder).lexically_normal().string(),
                 .preset = settings.preset,
                 .odometry = sequence.coverage,
                 .map = map});
  return {sequence.name, folder, writer.counts(), writer.statistics(), map};
}

}  // namespace armature
