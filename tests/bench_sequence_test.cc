// SPDX-License-Identifier: BSD-3-Clause
// Frames in memory, of another size, and with a given number of objects.
#include "bench/bench_sequence.h"

#include <gtest/gtest.h>

#include "support/bench_fakes.h"
#include "support/expect_input_error.h"
#include "support/tiny_sequence.h"

namespace armature {
namespace {

using testing::BoxSequence;
using testing::TempFolder;

std::vector<double> WidthsOf(const BenchFrame& frame) {
  std::vector<double> widths;
  for (const Detection& detection : frame.input.detections) widths.push_back(detection.box.width);
  return widths;
}

TEST(BenchSequence, LoadsGrayImagesWithTheirDetections) {
  const TempFolder folder;
  testing::WriteTinySequence(folder);
  const Sequence sequence = LoadSequence(folder.path(), {"chair", "table"});
  const BenchSequence loaded = LoadBenchSequence(sequence, 0);
  ASSERT_EQ(loaded.frames.size(), 2u);
  EXPECT_EQ(loaded.name, "tiny");
  EXPECT_EQ(loaded.frames[0].gray.type(), CV_8UC1);
  EXPECT_EQ(loaded.frames[1].input.detections.size(), 2u);
  EXPECT_TRUE(loaded.up_odom);
  EXPECT_TRUE(loaded.frames[1].input.T_odom_camera);
  testing::ExpectInputError([&] { LoadBenchSequence(sequence, 1); }, {"1 frames", "detections", "--frames"});
}

TEST(BenchSequence, FillsFramesWithTheirOwnObjectsLargestFirst) {
  const FilledSequence filled = WithObjects(BoxSequence({2, 0, 5}), 3);
  ASSERT_EQ(filled.sequence.frames.size(), 3u);
  EXPECT_EQ(WidthsOf(filled.sequence.frames[0]), (std::vector<double>{2, 1, 2}));
  EXPECT_TRUE(WidthsOf(filled.sequence.frames[1]).empty());
  EXPECT_EQ(WidthsOf(filled.sequence.frames[2]), (std::vector<double>{5, 4, 3}));
  EXPECT_NEAR(filled.repeated_share, 1.0 / 6, 1e-12);
}

TEST(BenchSequence, ResizesImageCameraAndBoxes) {
  BenchSequence sequence = BoxSequence({1});
  sequence.frames[0].gray = cv::Mat(48, 64, CV_8UC1, cv::Scalar(7));
  const BenchSequence resized = Resized(sequence, 128, 24);
  EXPECT_EQ(resized.frames[0].gray.size(), cv::Size(128, 24));
  EXPECT_EQ(ImageSize(resized.camera), "128x24");
  EXPECT_EQ(resized.camera.fx, 120);
  EXPECT_EQ(resized.camera.fy, 30.5);
  EXPECT_EQ(resized.camera.cx, 63.5);  // the image's middle stays its middle
  EXPECT_EQ(resized.camera.cy, 11.5);
  const Box& box = resized.frames[0].input.detections[0].box;
  EXPECT_EQ(box.x, 8);
  EXPECT_EQ(box.y, 4);
  EXPECT_EQ(box.width, 2);
  EXPECT_EQ(box.height, 5);
}

TEST(BenchSequence, FirstFramesAreAtMostThoseThereAre) {
  const BenchSequence sequence = BoxSequence({1, 1, 1});
  EXPECT_EQ(FirstFrames(sequence, 2).frames.size(), 2u);
  EXPECT_EQ(FirstFrames(sequence, 9).frames.size(), 3u);
}

}  // namespace
}  // namespace armature
