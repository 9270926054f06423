// SPDX-License-Identifier: BSD-3-Clause
#include "bench/bench_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "base/errors.h"
#include "base/interrupt.h"
#include "io/image.h"

namespace armature {
namespace {

BenchFrame LoadFrame(const Sequence& sequence, size_t index) {
  const ImageResult loaded = ReadImage(sequence.images[index].file, sequence.camera);
  if (!loaded.image) throw InputError(loaded.error);
  BenchFrame frame;
  cv::cvtColor(*loaded.image, frame.gray, cv::COLOR_BGR2GRAY);
  frame.input = {sequence.images[index].timestamp, sequence.detections[index], sequence.T_odom_camera[index]};
  return frame;
}

size_t CountFrames(const Sequence& sequence, size_t limit) {
  return limit > 0 ? std::min(limit, sequence.images.size()) : sequence.images.size();
}

// The same without frames.
BenchSequence Emptied(const BenchSequence& sequence) {
  return {sequence.name,         sequence.camera, sequence.up_odom, sequence.odometry_metric, {},
          sequence.camera_height};
}

// Pixel centres are whole numbers: a picture of `scale` times the width reaches from -0.5 to scale w - 0.5.
double ScaledCentre(double pixel, double scale) { return (pixel + 0.5) * scale - 0.5; }

}  // namespace

void CheckHasObjects(const Sequence& sequence, size_t limit) {
  const size_t count = CountFrames(sequence, limit);
  const auto first = sequence.detections.begin(), end = first + static_cast<long>(count);
  if (std::any_of(first, end, [](const auto& detections) { return !detections.empty(); })) return;
  throw InputError(
      fmt::format("{}: none of its {} frames has an object to be timed; give a sequence with detections, or "
                  "more --frames",
                  sequence.folder.string(), count));
}

BenchSequence LoadBenchSequence(const Sequence& sequence, size_t limit) {
  CheckHasObjects(sequence, limit);
  BenchSequence loaded{sequence.name,         sequence.camera, sequence.up, sequence.odometry_metric, {},
                       sequence.camera_height};
  for (size_t i = 0; i < CountFrames(sequence, limit); ++i) {
    ThrowIfInterrupted();
    loaded.frames.push_back(LoadFrame(sequence, i));
  }
  return loaded;
}

BenchSequence FirstFrames(const BenchSequence& sequence, size_t count) {
  BenchSequence first = Emptied(sequence);
  const auto end = sequence.frames.begin() + static_cast<long>(std::min(count, sequence.frames.size()));
  first.frames.assign(sequence.frames.begin(), end);
  return first;
}

BenchSequence Resized(const BenchSequence& sequence, int width, int height) {
  BenchSequence resized = Emptied(sequence);
  Camera& camera = resized.camera;
  const double x = static_cast<double>(width) / camera.width, y = static_cast<double>(height) / camera.height;
  camera.width = width;
  camera.height = height;
  camera.fx *= x;
  camera.fy *= y;
  camera.cx = ScaledCentre(camera.cx, x);
  camera.cy = ScaledCentre(camera.cy, y);
  const int interpolation = x * y < 1 ? cv::INTER_AREA : cv::INTER_LINEAR;
  for (const BenchFrame& frame : sequence.frames) {
    BenchFrame& to = resized.frames.emplace_back();
    cv::resize(frame.gray, to.gray, {width, height}, 0, 0, interpolation);
    to.input = frame.input;
    for (Detection& detection : to.input.detections) {
      const Box& box = detection.box;
      detection.box = {box.x * x, box.y * y, box.width * x, box.height * y};
    }
  }
  return resized;
}

FilledSequence WithObjects(const BenchSequence& sequence, size_t count) {
  FilledSequence filled{Emptied(sequence)};
  size_t all = 0, repeated = 0;
  for (const BenchFrame& frame : sequence.frames) {
    BenchFrame& to = filled.sequence.frames.emplace_back(frame);
    std::vector<Detection> own = frame.input.detections;
    if (own.empty()) continue;
    std::stable_sort(own.begin(), own.end(),
                     [](const Detection& a, const Detection& b) { return a.box.area() > b.box.area(); });
    to.input.detections.clear();
    for (size_t i = 0; i < count; ++i) to.input.detections.push_back(own[i % own.size()]);
    all += count;
    repeated += count - std::min(count, own.size());
  }
  filled.repeated_share = all > 0 ? static_cast<double>(repeated) / static_cast<double>(all) : 0;
  return filled;
}

std::string ImageSize(const Camera& camera) { return fmt::format("{}x{}", camera.width, camera.height); }

}  // namespace armature
