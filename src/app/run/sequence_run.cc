// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/sequence_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "app/run/jitter.h"
#include "app/run/video_file.h"
#include "base/console.h"
#include "base/errors.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "base/stage_clock.h"
#include "drawing/overlay.h"
#include "io/image.h"
#include "io/run_writer.h"
#include "pipeline/frame_pipeline.h"
#include "pipeline/one_ahead.h"

namespace armature {
namespace {

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// A frame before its objects are looked for.
struct PreparedFrame {
  ImageResult colour;  // none where nobody looks at it
  double load_ms = 0;
  Clock::time_point loaded;  // when the image was there
  DetectedLines lines;
};

// Whether pictures are looked at: lines may be known, and nobody may want to see them drawn.
bool NeedsPictures(const Sequence& sequence, const SequenceRunSettings& settings) {
  return sequence.segments.empty() || settings.overlays || !settings.video.empty();
}

PreparedFrame Prepare(const Sequence& sequence, size_t index, const SequenceRunSettings& settings,
                      FramePipeline& pipeline) {
  PreparedFrame prepared;
  cv::Mat gray;
  if (NeedsPictures(sequence, settings)) {
    const StageClock clock(prepared.load_ms);
    prepared.colour = ReadImage(sequence.images[index].file, sequence.camera);
    if (prepared.colour.image) cv::cvtColor(*prepared.colour.image, gray, cv::COLOR_BGR2GRAY);
  }
  prepared.loaded = Clock::now();
  if (!sequence.segments.empty())
    prepared.lines.segments = sequence.segments[index];
  else if (prepared.colour.image)
    prepared.lines = pipeline.DetectLines(gray, sequence.detections[index]);
  if (settings.jitter > 0)
    JitterSegments(static_cast<std::uint64_t>(settings.jitter), index, prepared.lines.segments);
  return prepared;
}

// The frames one after the other, prepared as they are asked for or one ahead.
class FrameSource {
 public:
  FrameSource(const Sequence& sequence, size_t count, const SequenceRunSettings& settings,
              FramePipeline& pipeline)
      : prepare_([&](size_t index) { return Prepare(sequence, index, settings, pipeline); }) {
    if (settings.pipelined) ahead_.emplace(count, prepare_);
  }
  PreparedFrame Frame(size_t index) { return ahead_ ? ahead_->Take() : prepare_(index); }

 private:
  std::function<PreparedFrame(size_t)> prepare_;
  std::optional<OneAhead<PreparedFrame>> ahead_;
};

FrameResult ProcessFrame(const Sequence& sequence, size_t index, PreparedFrame& prepared,
                         FramePipeline& pipeline) {
  const FrameInput input{sequence.images[index].timestamp, sequence.detections[index],
                         sequence.T_odom_camera[index]};
  FrameResult frame = pipeline.Process(std::move(prepared.lines), input);
  frame.times.load = prepared.load_ms;
  return frame;
}

// What was found in each frame, as pictures and as a video, where they are asked for.
class Overlays {
 public:
  Overlays(const Sequence& sequence, const SequenceRunSettings& settings, const std::filesystem::path& run)
      : camera_(sequence.camera), models_(settings.models) {
    if (settings.overlays) folder_ = run / "overlays";
    if (!settings.video.empty())
      video_.emplace(settings.video, sequence.fps, cv::Size(camera_.width, camera_.height));
  }

  void Add(size_t index, const cv::Mat& image, const FrameResult& frame) {
    if (folder_.empty() && !video_) return;
    const cv::Mat overlay = DrawOverlay(Undistorted(image, camera_), frame, models_, camera_);
    if (!folder_.empty()) WritePictureInside(folder_ / fmt::format("{:06}.jpg", index), overlay);
    if (video_) video_->Add(overlay);
  }

  void Finish() {
    if (video_) video_->Finish();
  }

  void Publish() {
    if (video_) video_->Publish();
  }

 private:
  const Camera& camera_;
  const std::vector<CategoryModel>& models_;
  std::filesystem::path folder_;  // empty: no pictures
  std::optional<VideoFile> video_;
};

void NoteOdometryGaps(const Sequence& sequence) {
  const OdometryCoverage& c = sequence.coverage;
  if (c.poses == 0) return;
  if (c.interpolated > 0) {
    Note(fmt::format("{}: {} of {} images take a pose between two of the odometry's", sequence.name,
                     c.interpolated, c.images));
  }
  if (c.gaps > 0) {
    Note(fmt::format("{}: {} of {} images have no odometry; gaps: {}, the longest {:.2f} s", sequence.name,
                     c.images - c.images_with_pose, c.images, c.gaps, c.longest_gap));
  }
}

// Where the odometry was not believed, by stamps.
struct Disbelief {
  std::vector<double> jumps, unit_changes;

  void Add(const FrameResult& frame) {
    if (frame.follows_jump) jumps.push_back(frame.timestamp);
    if (frame.unit_changed) unit_changes.push_back(frame.timestamp);
  }
};

void NoteDisbelief(const std::string& sequence, const Disbelief& disbelief) {
  if (!disbelief.jumps.empty()) {
    Note(fmt::format(
        "{}: the odometry jumps {} times, first to the image at {:.3f} s; the map does not rely on "
        "these steps",
        sequence, disbelief.jumps.size(), disbelief.jumps.front()));
  }
  if (!disbelief.unit_changes.empty()) {
    Note(fmt::format(
        "{}: the odometry's unit changes {} times, first shortly before {:.3f} s; later steps were "
        "brought to the unit before it",
        sequence, disbelief.unit_changes.size(), disbelief.unit_changes.front()));
  }
}

// Solves the map and writes it; without odometry there is none, and its files are empty.
std::optional<MapSummary> WriteMaps(const FramePipeline& pipeline, RunWriter& writer) {
  const StepDetail step("the map is solved");
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

// As the summary names it.
std::string DetectionsFile(const Sequence& sequence) {
  if (sequence.detections_file.empty()) return "";
  return std::filesystem::absolute(sequence.detections_file).lexically_normal().string();
}

size_t FrameCount(const Sequence& sequence, int limit) {
  if (limit <= 0) return sequence.images.size();
  return std::min(sequence.images.size(), static_cast<size_t>(limit));
}

Sequence Jittered(Sequence sequence, int jitter) {
  for (size_t i = 0; jitter > 0 && i < sequence.detections.size(); ++i)
    JitterBoxes(static_cast<std::uint64_t>(jitter), i, sequence.camera, sequence.detections[i]);
  return sequence;
}

// All frames, from the image to the result.
FramePace RunFrames(const Sequence& sequence, const SequenceRunSettings& settings, FramePipeline& pipeline,
                    RunWriter& writer, Overlays& overlays) {
  const size_t count = FrameCount(sequence, settings.frames);
  Progress progress(sequence.name + ": frames", static_cast<long>(count));
  FramePace pace;
  Disbelief disbelief;
  const Clock::time_point start = Clock::now();
  FrameSource frames(sequence, count, settings, pipeline);
  const bool needs_picture = NeedsPictures(sequence, settings);
  for (size_t i = 0; i < count; ++i) {
    ThrowIfInterrupted();
    PreparedFrame prepared = frames.Frame(i);
    const ImageResult& colour = prepared.colour;
    if (needs_picture && !colour.image) {
      if (i == 0) throw InputError(colour.error);
      Note("skipped " + colour.error);
      writer.AddSkippedImage(sequence.images[i].timestamp, colour.error);
    } else {
      const FrameResult frame = ProcessFrame(sequence, i, prepared, pipeline);
      pace.latency_ms.push_back(1000 * SecondsSince(prepared.loaded));
      disbelief.Add(frame);
      writer.AddFrame(frame);
      if (needs_picture) overlays.Add(i, *colour.image, frame);
    }
    progress.Step();
  }
  NoteDisbelief(sequence.name, disbelief);
  pace.frames_per_second = static_cast<double>(count) / SecondsSince(start);
  return pace;
}

}  // namespace

SequenceRunResult RunSequence(const Sequence& given, const SequenceRunSettings& settings,
                              const std::filesystem::path& folder) {
  const Sequence sequence = Jittered(given, settings.jitter);
  RunWriter writer(folder, settings.models);
  writer.WriteConfig(settings.config_yaml);
  FramePipeline pipeline(settings.options, sequence.camera, settings.models, sequence.up,
                         sequence.odometry_metric, sequence.camera_height);
  NoteOdometryGaps(sequence);
  Overlays overlays(sequence, settings, writer.partial());
  const FramePace pace = RunFrames(sequence, settings, pipeline, writer, overlays);
  ThrowIfInterrupted();
  overlays.Finish();
  const std::optional<MapSummary> map = WriteMaps(pipeline, writer);
  ThrowIfInterrupted();
  writer.Finish({.sequence = sequence.name,
                 .sequence_folder = std::filesystem::absolute(sequence.folder).lexically_normal().string(),
                 .detections = DetectionsFile(sequence),
                 .jitter = settings.jitter,
                 .preset = settings.preset,
                 .threads = settings.pipelined ? 2 : 1,
                 .odometry = sequence.coverage,
                 .map = map,
                 .pace = pace});
  overlays.Publish();
  return {sequence.name, folder, settings.video, writer.counts(), writer.statistics(), pace, map};
}

}  // namespace armature
