// SPDX-License-Identifier: BSD-3-Clause
// Bad input of `armature run`: one line that names the file and line, exit status 2, nothing left behind.
#include <gtest/gtest.h>

#include "support/program.h"
#include "support/tiny_sequence.h"

namespace armature {
namespace {

using testing::AllFiles;
using testing::ExpectBadInput;
using testing::kTinyDetectionsHeader;

class AppBadInput : public ::testing::Test {
 protected:
  AppBadInput() { WriteTinySequence(folder_); }

  // Runs the sequence as it was spoilt.
  void ExpectRefused(const std::vector<std::string>& texts, const std::vector<std::string>& more = {}) const {
    const std::set<std::string> before = AllFiles(folder_.path());
    std::vector<std::string> arguments = {"run", folder_.path().string(), "--out",
                                          (folder_ / "run").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    ExpectBadInput(arguments, texts);
    EXPECT_EQ(AllFiles(folder_.path()), before);
  }

  void WriteDetection(const std::string& row) const {
    folder_.Write("detections.csv", kTinyDetectionsHeader + row + "\n");
  }

  testing::TempFolder folder_;
};

TEST_F(AppBadInput, TheUnspoiltSequenceRuns) {
  testing::RunOk({"run", folder_.path(), "--out", folder_ / "run"});
}

TEST_F(AppBadInput, UnknownCategory) {
  WriteDetection("0.2,sofa,5,6,20,30,0.9,,,");
  ExpectRefused({"detections.csv:2", "sofa", "chair"});
}

TEST_F(AppBadInput, MissingFile) {
  std::filesystem::remove(folder_ / "detections.csv");
  ExpectRefused({"detections.csv"});
}

TEST_F(AppBadInput, MissingImage) {
  std::filesystem::remove(folder_ / "rgb/1.png");
  ExpectRefused({"rgb.txt:3", "rgb/1.png"});
}

TEST_F(AppBadInput, MalformedCsv) {
  WriteDetection("0.2,chair,5,6,20");
  ExpectRefused({"detections.csv:2"});
}

TEST_F(AppBadInput, NonFiniteNumber) {
  WriteDetection("0.2,chair,nan,6,20,30,0.9,,,");
  ExpectRefused({"detections.csv:2", "nan"});
}

TEST_F(AppBadInput, BoxOutsideTheImage) {
  WriteDetection("0.2,chair,500,6,20,30,0.9,,,");
  ExpectRefused({"detections.csv:2", "outside"});
}

TEST_F(AppBadInput, DetectionWithoutImage) {
  WriteDetection("0.3,chair,5,6,20,30,0.9,,,");
  ExpectRefused({"detections.csv:2", "0.3"});
}

TEST_F(AppBadInput, UnsortedStamps) {
  folder_.Write("rgb.txt", "0.2 rgb/0.png\n0.0 rgb/1.png\n");
  ExpectRefused({"rgb.txt:2", "sort"});
}

TEST_F(AppBadInput, FirstImageOfAnotherSize) {
  cv::imwrite((folder_ / "rgb/0.png").string(), cv::Mat(20, 30, CV_8UC3, cv::Scalar(0, 0, 0)));
  ExpectRefused({"rgb/0.png", "30 x 20", "64 x 48"});
}

TEST_F(AppBadInput, FirstImageUnreadable) {
  folder_.Write("rgb/0.png", "not an image");
  ExpectRefused({"rgb/0.png"});
}

TEST_F(AppBadInput, UnknownKeyInTheSequence) {
  folder_.Write("sequence.yaml", std::string(testing::kTinySequenceYaml) + "fsp: 5\n");
  ExpectRefused({"sequence.yaml:13", "fsp", "fps"});
}

TEST_F(AppBadInput, UnknownOptionInTheConfiguration) {
  folder_.Write("my.yaml", "# mine\nlines:\n  detectr: lsd\n");
  ExpectRefused({"my.yaml:3", "lines.detectr", "lines.detector"},
                {"--config", (folder_ / "my.yaml").string()});
}

TEST_F(AppBadInput, BadSettings) {
  ExpectRefused({"--set", "lines.detector", "lsd"}, {"--set", "lines.detector=canny"});
  ExpectRefused({"--set", "lines.min_length", "1000"}, {"--set", "lines.min_length=1e9"});
  ExpectRefused({"--set", "key=value"}, {"--set", "lines.min_length"});
  ExpectRefused({"--set", "lines.min_length"}, {"--set", "min_length=5"});
}

TEST_F(AppBadInput, UnknownPresetConfigurationAndCategories) {
  ExpectRefused({"--preset", "papre", "paper"}, {"--preset", "papre"});
  ExpectRefused({"absent.yaml"}, {"--config", (folder_ / "absent.yaml").string()});
  ExpectRefused({"rgb"}, {"--categories", (folder_ / "rgb").string()});
  ExpectRefused({"rgb/presets", "--configs"}, {"--configs", (folder_ / "rgb").string()});
}

TEST_F(AppBadInput, BadUsage) {
  ExpectRefused({"--frames -1"}, {"--frames", "-1"});
  ExpectRefused({"--frames"}, {"--frames", "many"});
  ExpectRefused({"--overlay"}, {"--overlay"});
  ExpectBadInput({"run", folder_.path()}, {"--out"});
  ExpectBadInput({"run", "--out", folder_ / "run"}, {"SEQUENCE"});
  ExpectBadInput({"run", folder_ / "absent", "--out", folder_ / "run"}, {"absent", "does not exist"});
}

TEST_F(AppBadInput, AFolderThatIsNoRunIsNotReplaced) {
  folder_.Write("run/notes.txt", "precious");
  ExpectRefused({"run", "not a finished run"});
}

TEST_F(AppBadInput, TwoSequencesOfOneName) {
  const testing::TempFolder other;
  WriteTinySequence(other);
  ExpectRefused({other.path().string(), folder_.path().string(), "tiny"}, {other.path().string()});
}

TEST_F(AppBadInput, ALaterSequenceIsCheckedBeforeTheFirstRuns) {
  const testing::TempFolder other;
  WriteTinySequence(other);
  other.Write("sequence.yaml", testing::TinySequenceYaml("other"));
  other.Write("rgb/0.png", "not an image");
  ExpectRefused({other.path().string(), "rgb/0.png"}, {other.path().string()});
}

}  // namespace
}  // namespace armature
