// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "geometry/rotation.h"
#include "io/sequence.h"
#include "support/expect_input_error.h"
#include "support/shared_data.h"
#include "support/temp_folder.h"
#include "support/tiny_sequence.h"

namespace armature {
namespace {

using testing::ExpectInputError;
using testing::kTinyDetectionsHeader;
using testing::kTinySequenceYaml;

const std::vector<std::string> kCategories{"chair", "laptop", "table"};

class SequenceTest : public ::testing::Test {
 protected:
  SequenceTest() { testing::WriteTinySequence(folder_); }

  Sequence Load() const { return LoadSequence(folder_.path(), kCategories); }

  // Replaces one file and expects the load to fail with all of the texts in the message.
  void ExpectErrorWith(const std::string& file, const std::string& content,
                       std::vector<std::string> texts) const {
    folder_.Write(file, content);
    texts.push_back(file);
    ExpectInputError([&] { Load(); }, texts);
  }

  void ExpectYamlError(const std::string& from, const std::string& to,
                       const std::vector<std::string>& texts) const {
    std::string yaml = kTinySequenceYaml;
    yaml.replace(yaml.find(from), from.size(), to);
    ExpectErrorWith("sequence.yaml", yaml, texts);
  }

  void ExpectDetectionError(const std::string& row, const std::vector<std::string>& texts) const {
    ExpectErrorWith("detections.csv", kTinyDetectionsHeader + row + "\n", texts);
  }

  testing::TempFolder folder_;
};

TEST_F(SequenceTest, ReadsEverything) {
  const Sequence sequence = Load();
  EXPECT_EQ(sequence.name, "tiny");
  EXPECT_EQ(sequence.fps, 5);
  EXPECT_EQ(sequence.camera.width, 64);
  EXPECT_EQ(sequence.camera.fy, 61);
  EXPECT_EQ(sequence.camera.distortion[0], 0.1);
  EXPECT_FALSE(sequence.odometry_metric);
  ASSERT_TRUE(sequence.up);
  EXPECT_TRUE(sequence.up->isApprox(Eigen::Vector3d(0, -1, 0)));
  ASSERT_EQ(sequence.images.size(), 2u);
  EXPECT_EQ(sequence.images[1].file, folder_ / "rgb/1.png");
  EXPECT_EQ(sequence.images[1].line, 3);
}

TEST_F(SequenceTest, AssignsDetectionsToImagesInRadians) {
  const Sequence sequence = Load();
  ASSERT_EQ(sequence.detections.size(), 2u);
  EXPECT_TRUE(sequence.detections[0].empty());
  ASSERT_EQ(sequence.detections[1].size(), 2u);
  const Detection& chair = sequence.detections[1][0];
  EXPECT_EQ(chair.category, "chair");
  EXPECT_NEAR(*chair.azimuth, 90 * kDegree, 1e-12);
  EXPECT_NEAR(*chair.elevation, -45 * kDegree, 1e-12);
  EXPECT_FALSE(chair.tilt);
  EXPECT_FALSE(sequence.detections[1][1].azimuth);
}

TEST_F(SequenceTest, MatchesPosesWithinAMillisecond) {
  const Sequence sequence = Load();
  EXPECT_FALSE(sequence.T_odom_camera[0]);
  ASSERT_TRUE(sequence.T_odom_camera[1]);
  EXPECT_EQ(sequence.T_odom_camera[1]->translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(sequence.odometry.size(), 2u);
}

TEST_F(SequenceTest, InterpolatesBetweenNearPoses) {
  folder_.Write("odometry.txt", "-0.1 0 0 0 0 0 0 1\n0.1 2 4 6 0 0 0 1\n0.3 4 4 6 0 0 0 1\n");
  Sequence sequence = Load();
  ASSERT_TRUE(sequence.T_odom_camera[0] && sequence.T_odom_camera[1]);
  EXPECT_TRUE(sequence.T_odom_camera[0]->translation().isApprox(Eigen::Vector3d(1, 2, 3)));
  EXPECT_TRUE(sequence.T_odom_camera[1]->translation().isApprox(Eigen::Vector3d(3, 4, 6)));
  EXPECT_EQ(sequence.coverage.interpolated, 2);
  sequence = LoadSequence(folder_.path(), kCategories, {.tolerance = 0.11, .max_gap = 0});
  EXPECT_EQ(sequence.coverage.interpolated, 0);
  EXPECT_EQ(sequence.coverage.images_with_pose, 2);
}

TEST_F(SequenceTest, ReadsOdometryInOtherFormats) {
  folder_.Write("odometry.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n0 -1 0 7 1 0 0 8 0 0 1 9\n");
  Sequence sequence = Load();
  EXPECT_EQ(sequence.odometry[1].timestamp, 0.2);
  EXPECT_TRUE(sequence.T_odom_camera[1]->translation().isApprox(Eigen::Vector3d(7, 8, 9)));
  folder_.Write("odometry.txt", "#timestamp,p,q\n0,1,2,3,1,0,0,0\n200000000,4,5,6,1,0,0,0\n");
  sequence = Load();
  EXPECT_TRUE(sequence.T_odom_camera[1]->translation().isApprox(Eigen::Vector3d(4, 5, 6)));
}

TEST_F(SequenceTest, NeedsNoOdometry) {
  std::filesystem::remove(folder_ / "odometry.txt");
  const Sequence sequence = Load();
  EXPECT_TRUE(sequence.odometry.empty());
  ASSERT_EQ(sequence.T_odom_camera.size(), 2u);
  EXPECT_FALSE(sequence.T_odom_camera[1]);
}

TEST_F(SequenceTest, ViewpointColumnsAreOptional) {
  folder_.Write("detections.csv", "timestamp,category,x,y,width,height,score\n0,chair,5,6,20,30,0.9\n");
  EXPECT_FALSE(Load().detections[0][0].azimuth);
}

TEST_F(SequenceTest, ReportsMissingFolderAndFiles) {
  ExpectInputError([&] { LoadSequence(folder_ / "nowhere", kCategories); }, {"nowhere", "does not exist"});
  ExpectInputError([&] { LoadSequence(folder_ / "rgb.txt", kCategories); }, {"rgb.txt", "not a folder"});
  for (const std::string file : {"detections.csv", "rgb.txt", "sequence.yaml"}) {
    std::filesystem::remove(folder_ / file);
    ExpectInputError([&] { Load(); }, {file, "cannot be opened"});
  }
}

TEST_F(SequenceTest, ReportsMalformedYaml) {
  ExpectErrorWith("sequence.yaml", "name: [tiny\nfps: 5\n", {".yaml:", "not valid YAML"});
  ExpectErrorWith("sequence.yaml", "- name\n", {".yaml:1", "map"});
  ExpectYamlError("fps: 5", "fps: fast", {".yaml:2", "'fps'", "'fast'"});
  ExpectYamlError("fps: 5", "fps: .nan", {".yaml:2", "finite"});
  ExpectYamlError("fps: 5", "fps: 5\nfps: 6", {".yaml:3", "twice"});
  ExpectYamlError("fps: 5\n", "", {"'fps'", "missing"});
}

TEST_F(SequenceTest, ReportsUnknownKeysWithTheNearest) {
  ExpectYamlError("fps: 5", "fsp: 5", {".yaml:2", "'fsp'", "'fps'"});
  ExpectYamlError("width:", "widht:", {".yaml:5", "'widht'", "'width'"});
}

TEST_F(SequenceTest, ReportsImpossibleCameras) {
  ExpectYamlError("fx: 60", "fx: 0", {".yaml:7", "camera.fx", "greater than 0"});
  ExpectYamlError("width: 64", "width: -64", {".yaml:5", "camera.width"});
  ExpectYamlError("width: 64", "width: 64.5", {".yaml:5", "camera.width", "whole"});
  ExpectYamlError("[0.1, 0, 0, 0, 0]", "[0.1, 0]", {".yaml:11", "distortion", "2 values", "k1"});
  ExpectYamlError("pinhole", "fisheye", {".yaml:4", "'fisheye'", "pinhole"});
}

TEST_F(SequenceTest, ReportsIntrinsicsThatNoCameraHas) {
  ExpectYamlError("fx: 60", "fx: 0.94", {".yaml:7", "camera.fx", "pixels"});
  ExpectYamlError("fy: 61", "fy: 1e9", {".yaml:8", "camera.fy"});
  ExpectYamlError("fx: 60", "fx: 6", {".yaml:7", "camera.fx", "61"});
  ExpectYamlError("cx: 31.5", "cx: 500", {".yaml:9", "camera.cx", "outside the image"});
  ExpectYamlError("cy: 23.5", "cy: -60", {".yaml:10", "camera.cy", "outside the image"});
  ExpectYamlError("[0.1, 0, 0, 0, 0]", "[1e6, 0, 0, 0, 0]", {".yaml:11", "distortion", "threefold"});
  ExpectYamlError("[0.1, 0, 0, 0, 0]", "[-1.5, 0, 0, 0, 0]", {".yaml:11", "distortion", "folds"});
  ExpectYamlError("width: 64", "width: 100000", {".yaml:5", "camera.width", "65535"});
}

TEST_F(SequenceTest, ReportsOtherBadSettings) {
  ExpectYamlError("fps: 5", "fps: 1e9", {".yaml:2", "fps"});
  ExpectYamlError("fps: 5", "fps: 1e-9", {".yaml:2", "fps"});
  ExpectYamlError("name: tiny", "name: ../tiny", {".yaml:1", "'../tiny'"});
  ExpectYamlError("up: [0, -2, 0]", "up: [0, 0, 0]", {".yaml:12", "'up'"});
  ExpectYamlError("up: [0, -2, 0]", "odometry_metric: maybe", {".yaml:12", "true or false"});
  ExpectYamlError("up: [0, -2, 0]", "camera_height: {metres: 0, sigma: 0.02}",
                  {".yaml:12", "metres", "more than 0"});
  ExpectYamlError("up: [0, -2, 0]", "camera_height: {metres: 1.2, sigma: -1}", {".yaml:12", "sigma"});
  ExpectYamlError("up: [0, -2, 0]", "camera_height: {metres: 1.2}", {".yaml:12", "sigma"});
  ExpectYamlError("up: [0, -2, 0]", "camera_height: {metres: 1.2, sigmas: 1}", {".yaml:12", "sigmas"});
}

TEST_F(SequenceTest, ReadsTheCamerasHeight) {
  EXPECT_FALSE(Load().camera_height);
  std::string yaml = testing::ReadFile(folder_ / "sequence.yaml");
  folder_.Write("sequence.yaml", yaml + "\ncamera_height: {metres: 1.25, sigma: 0.02}\n");
  const auto height = Load().camera_height;
  ASSERT_TRUE(height);
  EXPECT_EQ(height->camera_height, 1.25);
  EXPECT_EQ(height->sigma, 0.02);
}

TEST_F(SequenceTest, ReportsBadImageLists) {
  ExpectErrorWith("rgb.txt", "0.0 rgb/0.png\n0.0 rgb/1.png\n", {"rgb.txt:2", "line 1"});
  ExpectErrorWith("rgb.txt", "0.2 rgb/0.png\n\n0.0 rgb/1.png\n", {"rgb.txt:3", "0.200000"});
  ExpectErrorWith("rgb.txt", "0.0 rgb/9.png\n", {"rgb.txt:1", "9.png", "does not exist"});
  ExpectErrorWith("rgb.txt", "zero rgb/0.png\n", {"rgb.txt:1", "'zero'"});
  ExpectErrorWith("rgb.txt", "0.0\n", {"rgb.txt:1", "timestamp filename"});
  ExpectErrorWith("rgb.txt", "# nothing\n", {"lists no image"});
}

TEST_F(SequenceTest, ReportsStampsThatAreNoSeconds) {
  const std::string images[] = {" rgb/0.png\n", " rgb/1.png\n"};
  const auto list = [&](const std::string& first, const std::string& second) {
    return first + images[0] + second + images[1];
  };
  ExpectErrorWith("rgb.txt", list("1403636580838555648", "1403636581038555648"),
                  {"rgb.txt:1", "nanoseconds?"});
  ExpectErrorWith("rgb.txt", list("1403636580838", "1403636581038"), {"rgb.txt:1", "milliseconds?"});
  ExpectErrorWith("rgb.txt", list("0", "1305031102.2"), {"rgb.txt:2", "41.4 years", "line 1"});
  // Counted from the first image, only the pace tells.
  for (const auto& [second, unit] :
       {std::pair{"200", "milliseconds?"}, {"200000", "microseconds?"}, {"200000000", "nanoseconds?"}})
    ExpectErrorWith("rgb.txt", list("0", second), {"rgb.txt", "fps", unit});
}

TEST_F(SequenceTest, TellsOfALongGapOnly) {
  folder_.Write("odometry.txt", "0.0 0 0 0 0 0 0 1\n");
  folder_.Write("rgb.txt", "0 rgb/0.png\n0.2 rgb/1.png\n2592000 rgb/0.png\n2592000.2 rgb/1.png\n");
  folder_.Write("detections.csv", testing::kTinyDetectionsHeader);
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(Load().images.size(), 4u);
  const std::string told = ::testing::internal::GetCapturedStderr();
  EXPECT_NE(told.find("rgb.txt:3: 30 days after the image before"), std::string::npos) << told;
}

TEST_F(SequenceTest, KeepsTheFirstOfRepeatedPosesOfOdometry) {
  folder_.Write("odometry.txt", "0.0 1 0 0 0 0 0 1\n0.0 2 0 0 0 0 0 1\n0.2 3 0 0 0 0 0 1\n");
  const Sequence sequence = Load();
  ASSERT_EQ(sequence.odometry.size(), 2u);
  EXPECT_EQ(sequence.T_odom_camera[0]->translation().x(), 1);
}

TEST_F(SequenceTest, AnImagesNameMayHaveAHashAndBlanks) {
  std::filesystem::copy_file(folder_ / "rgb/0.png", folder_ / "rgb/frame #1.png");
  std::filesystem::copy_file(folder_ / "rgb/0.png", folder_ / "rgb/frame#2.png");
  folder_.Write("rgb.txt",
                "# stamps\n0.0 rgb/frame #1.png\n0.1 rgb/frame#2.png # the second\n0.2 rgb/1.png # last\n");
  const std::vector<ImageEntry> images = ReadImageList(folder_ / "rgb.txt");
  ASSERT_EQ(images.size(), 3u);
  EXPECT_EQ(images[0].file, folder_ / "rgb/frame #1.png");
  EXPECT_EQ(images[1].file, folder_ / "rgb/frame#2.png");
  EXPECT_EQ(images[2].file, folder_ / "rgb/1.png");
  ExpectErrorWith("rgb.txt", "0.0 # none\n", {"rgb.txt:1", "timestamp filename"});
}

TEST_F(SequenceTest, NeedsNoPicturesWhereLinesAreGiven) {
  folder_.Write("rgb.txt", "0.0 -\n0.2 -\n");
  folder_.Write("segments.csv", "timestamp,x1,y1,x2,y2\n0.2,1,2,4,6\n0.2,10,10,30,10\n");
  const Sequence sequence = Load();
  EXPECT_TRUE(sequence.images[1].file.empty());
  ASSERT_EQ(sequence.segments.size(), 2u);
  EXPECT_TRUE(sequence.segments[0].empty());
  ASSERT_EQ(sequence.segments[1].size(), 2u);
  EXPECT_EQ(sequence.segments[1][0].length(), 20);  // the longest first
  EXPECT_EQ(sequence.segments[1][1].p2, Eigen::Vector2d(4, 6));
}

TEST_F(SequenceTest, ReportsBadSegments) {
  const auto expect = [&](const std::string& rows, const std::vector<std::string>& texts) {
    ExpectErrorWith("segments.csv", "timestamp,x1,y1,x2,y2\n" + rows, texts);
  };
  expect("0.2,1,2,1,2\n", {":2:", "one point"});
  expect("0.1,1,2,3,4\n", {":2:", "no image within 1 ms"});
  expect("0.2,1,2,3\n", {":2"});
  expect("0.2,1,nan,3,4\n", {":2"});
}

TEST_F(SequenceTest, ReportsAnImageWithNeitherPictureNorLines) {
  ExpectErrorWith("rgb.txt", "0.0 rgb/0.png\n0.2 -\n", {":2:", "no picture", "segments.csv"});
}

TEST_F(SequenceTest, ReportsBadDetections) {
  ExpectDetectionError("0.2,chair,5,6,20,30,0.9,,120,", {"csv:2", "elevation_deg 120", "-90..90"});
  ExpectDetectionError("0.2,chair,5,6,20,30,0.9,1000,,", {"csv:2", "azimuth_deg 1000"});
  ExpectDetectionError("0.2,chair,5,6,20,30,0.9,,,-400", {"csv:2", "tilt_deg -400"});
  ExpectDetectionError("0.2,chiar,5,6,20,30,0.9,,,", {"csv:2", "'chiar'", "'chair'", "laptop"});
  ExpectDetectionError("0.2,chair,nan,6,20,30,0.9,,,", {"csv:2", "column 'x'", "finite"});
  ExpectDetectionError("0.2,chair,5,6,20,30,0.9,1e999,,", {"csv:2", "azimuth_deg"});
  ExpectDetectionError("0.2,chair,5,6,0,30,0.9,,,", {"csv:2", "greater than 0"});
  ExpectDetectionError("0.2,chair,70,6,20,30,0.9,,,", {"csv:2", "outside the 64 x 48 image"});
  ExpectDetectionError("0.2,chair,5,6,20,30,1.1,,,", {"csv:2", "1.1", "0..1"});
  ExpectDetectionError("0.1,chair,5,6,20,30,1,,,", {"csv:2", "0.100000", "rgb.txt"});
  ExpectDetectionError("0.2,chair,5,6,20", {"csv:2", "5 fields", "10"});
}

TEST_F(SequenceTest, ReportsBadDetectionHeaders) {
  ExpectErrorWith("detections.csv", "", {"has no header"});
  ExpectErrorWith("detections.csv", "timestamp,category,x,y,width,height\n", {"csv:1", "'score'"});
  ExpectErrorWith("detections.csv", "timestamp,category,x,y,width,height,score,azimut_deg\n",
                  {"csv:1", "'azimut_deg'", "'azimuth_deg'"});
}

TEST_F(SequenceTest, ReportsBadOdometry) {
  ExpectErrorWith("odometry.txt", "0 0 0 0 0 0 0 2\n", {"odometry.txt:1", "length 2"});
  ExpectErrorWith("odometry.txt", "0 0 0 0 0 0 0\n", {"odometry.txt:1", "7 numbers"});
  ExpectErrorWith("odometry.txt", "0 0 0 inf 0 0 0 1\n", {"odometry.txt:1", "finite"});
  ExpectErrorWith("odometry.txt", "1 0 0 0 0 0 0 1\n0 0 0 0 0 0 0 1\n", {"odometry.txt:2", "line 1"});
  ExpectErrorWith("odometry.txt", "7 0 0 0 0 0 0 1\n", {"odometry.txt:1", "1 ms", "7 to 7 s", "0 to 0.2 s"});
  ExpectErrorWith("odometry.txt", "1403636580838555648 0 0 0 0 0 0 1\n", {"odometry.txt:1", "nanoseconds?"});
  ExpectErrorWith("odometry.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n", {"1 poses", "2 stamps"});
  ExpectErrorWith("odometry.txt", "# nothing\n", {"has no pose"});
}

TEST(SequenceOnRealData, LoadsTheSharedSequences) {
  ARMATURE_SHARED_DATA_OR_SKIP(folder, "sequences");
  const Sequence office = LoadSequence(folder / "office_dev", kCategories);
  EXPECT_EQ(office.images.size(), 80u);
  EXPECT_TRUE(office.up);
  const Sequence kitchen = LoadSequence(folder / "redkitchen_a", kCategories);
  EXPECT_EQ(kitchen.images.size(), 250u);
  EXPECT_TRUE(kitchen.T_odom_camera.back());
  EXPECT_EQ(kitchen.coverage.images_with_pose, 250);
  EXPECT_EQ(kitchen.coverage.interpolated, 0);
  EXPECT_EQ(kitchen.coverage.gaps, 0);
}

}  // namespace
}  // namespace armature
