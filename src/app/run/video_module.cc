// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/video_module.h"

#include <memory>
#include <opencv2/videoio.hpp>
#include <string_view>
#include <vector>

namespace {

// In the order of preference: what browsers play comes first.
std::vector<int> Codecs(std::string_view file) {
  if (file.ends_with(".avi")) return {cv::VideoWriter::fourcc('M', 'J', 'P', 'G')};
  return {cv::VideoWriter::fourcc('a', 'v', 'c', '1'), cv::VideoWriter::fourcc('m', 'p', '4', 'v')};
}

}  // namespace

void* ArmatureOpenVideo(const char* file, double fps, int width, int height) {
  auto writer = std::make_unique<cv::VideoWriter>();
  for (const int codec : Codecs(file)) {
    if (writer->open(file, codec, fps, {width, height})) return writer.release();
  }
  return nullptr;
}

void ArmatureAddFrame(void* video, const cv::Mat* frame) {
  static_cast<cv::VideoWriter*>(video)->write(*frame);
}

long ArmatureCountFrames(const char* file) {
  cv::VideoCapture player(file);
  long frames = 0;
  while (player.grab()) ++frames;
  return frames;
}

void ArmatureCloseVideo(void* video) { delete static_cast<cv::VideoWriter*>(video); }
