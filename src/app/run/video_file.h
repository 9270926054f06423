// SPDX-License-Identifier: BSD-3-Clause
// A video that is there whole or not at all.
#pragma once

#include <filesystem>
#include <memory>
#include <opencv2/core.hpp>

namespace armature {

// Throws InputError for an ending other than .mp4 and .avi.
void CheckVideoName(const std::filesystem::path& file);

class VideoFile {
 public:
  // Writes aside, beside the file; creates the folders around it. `size`: of the frames; an odd last row or
  // column is cut. Throws InputError: another ending, a folder that cannot be written, no encoder in this
  // OpenCV.
  VideoFile(const std::filesystem::path& file, double fps, const cv::Size& size);
  // Removes what was written if it was not published.
  ~VideoFile();
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  // An 8-bit BGR frame of this size.
  void Add(const cv::Mat& frame);

  // No more frames. Throws InputError when not all of them are in the file: the disk is full.
  void Finish();

  // Puts the finished video in place. Throws InputError where it cannot be written.
  void Publish();

 private:
  struct Module;

  void Close();

  std::filesystem::path file_, aside_;  // aside: empty once published
  std::unique_ptr<Module> module_;
  void* video_ = nullptr;  // null once it is closed
  long frames_ = 0;
};

}  // namespace armature
