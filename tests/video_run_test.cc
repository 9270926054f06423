// SPDX-License-Identifier: BSD-3-Clause
// `armature run --video`, read back.
#include <gtest/gtest.h>

#include <opencv2/videoio.hpp>

#include "support/program.h"
#include "support/tiny_sequence.h"

namespace armature {
namespace {

using testing::ExpectBadInput;
using testing::RunOk;

// Two frames of 64 x 48 pixels, 5 a second.
class RunVideo : public ::testing::Test {
 protected:
  RunVideo() { WriteTinySequence(sequence_); }

  static void ExpectTheVideo(const std::filesystem::path& file) {
    cv::VideoCapture video(file.string());
    ASSERT_TRUE(video.isOpened()) << file;
    EXPECT_DOUBLE_EQ(video.get(cv::CAP_PROP_FPS), 5);
    cv::Mat frame;
    int frames = 0;
    for (; video.read(frame); ++frames) EXPECT_EQ(frame.size(), cv::Size(64, 48));
    EXPECT_EQ(frames, 2);
  }

  testing::TempFolder sequence_, out_;
};

TEST_F(RunVideo, HasAllFramesAtTheirSizeAndRate) {
  for (const char* name : {"look.mp4", "deep/look.avi"}) {
    RunOk({"run", sequence_.path(), "--out", out_ / "run", "--video", out_ / name});
    ExpectTheVideo(out_ / name);
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(out_ / "deep"), {}), 1);  // nothing aside
}

TEST_F(RunVideo, IsOneForEachOfSeveralSequences) {
  const testing::TempFolder other;
  WriteTinySequence(other);
  other.Write("sequence.yaml", testing::TinySequenceYaml("other"));
  RunOk({"run", sequence_.path(), other.path(), "--out", out_ / "runs", "--video", out_ / "videos"});
  ExpectTheVideo(out_ / "videos/tiny.mp4");
  ExpectTheVideo(out_ / "videos/other.mp4");
}

TEST_F(RunVideo, BadNamesAreRefusedBeforeTheFirstFrame) {
  ExpectBadInput({"run", sequence_.path(), "--out", out_ / "run", "--video", out_ / "look.gif"},
                 {"look.gif", ".mp4"});
  EXPECT_FALSE(std::filesystem::exists(out_ / "run"));
}

TEST_F(RunVideo, ARunThatFailsLeavesNone) {
  sequence_.Write("rgb/0.png", "not an image");
  const auto result =
      testing::RunProgram({"run", sequence_.path(), "--out", out_ / "run", "--video", out_ / "look.mp4"});
  EXPECT_EQ(result.status, 2);
  EXPECT_TRUE(std::filesystem::is_empty(out_.path()));
}

}  // namespace
}  // namespace armature
