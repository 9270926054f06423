// SPDX-License-Identifier: BSD-3-Clause
// What the module armature_video.so, which video_file.cc loads, gives to it.
#pragma once

namespace cv {
class Mat;
}

extern "C" {

// Starts a file of frames of this size. Null where OpenCV has no encoder for the file's ending.
void* ArmatureOpenVideo(const char* file, double fps, int width, int height);
// An 8-bit BGR frame of that size.
void ArmatureAddFrame(void* video, const cv::Mat* frame);
void ArmatureCloseVideo(void* video);
// How many frames a player finds in the file: of an encoder's failures OpenCV says nothing.
long ArmatureCountFrames(const char* file);
}
