// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <utility>

#include "io/exif_orientation.h"
#include "io/image.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

class ImageTest : public ::testing::Test {
 protected:
  ImageTest() {
    cv::Mat noise(48, 64, CV_8UC3);
    cv::randu(noise, 0, 255);
    cv::imwrite((folder_ / "a.jpg").string(), noise);
    cv::imwrite((folder_ / "a.png").string(), noise);
    camera_.width = 64;
    camera_.height = 48;
  }

  void ExpectError(const std::string& file, const std::string& text) const {
    const ImageResult result = ReadImage(folder_ / file, camera_);
    EXPECT_FALSE(result.image);
    EXPECT_NE(result.error.find(file), std::string::npos) << result.error;
    EXPECT_NE(result.error.find(text), std::string::npos) << result.error;
  }

  testing::TempFolder folder_;
  Camera camera_;
};

TEST_F(ImageTest, ReadsCompleteImages) {
  for (const std::string file : {"a.jpg", "a.png"}) {
    const ImageResult result = ReadImage(folder_ / file, camera_);
    ASSERT_TRUE(result.image) << result.error;
    EXPECT_EQ(result.image->type(), CV_8UC3);
  }
}

TEST_F(ImageTest, ReportsTruncatedImages) {
  const std::string bytes = testing::ReadFile(folder_ / "a.jpg");
  folder_.Write("cut.jpg", bytes.substr(0, bytes.size() / 2));
  ExpectError("cut.jpg", "not a complete image");
}

// OpenCV would try the decoder of medical images on it, which may end the program.
TEST_F(ImageTest, ReportsAFormatThatNoCameraWrites) {
  std::string bytes = testing::ReadFile(folder_ / "a.png");
  std::swap(bytes[0], bytes[1]);
  folder_.Write("swapped.png", bytes);
  ExpectError("swapped.png", "not a complete image");
  folder_.Write("medical.png", std::string(128, '\0') + "DICM" + bytes);
  ExpectError("medical.png", "not a complete image");
}

TEST_F(ImageTest, ReportsOtherFiles) {
  folder_.Write("text.jpg", "no image");
  folder_.Write("empty.png", "");
  ExpectError("text.jpg", "not a complete image");
  ExpectError("empty.png", "not a complete image");
  ExpectError("absent.png", "cannot be opened");
}

std::string NumberBytes(size_t value, int bytes, bool is_little) {
  std::string text;
  for (int i = 0; i < bytes; ++i)
    text += static_cast<char>(value >> 8 * (is_little ? i : bytes - 1 - i) & 0xFF);
  return text;
}

// The tag alone, in either order of bytes.
std::string OrientationBlock(size_t orientation, bool is_little) {
  std::string block = is_little ? "II" : "MM";
  for (const auto& [value, bytes] : {std::pair<size_t, int>{42, 2},
                                     {8, 4},
                                     {1, 2},
                                     {0x0112, 2},
                                     {3, 2},
                                     {1, 4},
                                     {orientation, 2},
                                     {0, 2},
                                     {0, 4}})
    block += NumberBytes(value, bytes, is_little);
  return block;
}

// Behind the first mark of a JPEG.
std::string JpegWithOrientation(const std::string& jpeg, const std::string& block) {
  const std::string content = std::string("Exif\0\0", 6) + block;
  return jpeg.substr(0, 2) + "\xFF\xE1" + NumberBytes(content.size() + 2, 2, false) + content +
         jpeg.substr(2);
}

// Behind the header of a PNG; without a right checksum.
std::string PngWithOrientation(const std::string& png, const std::string& block) {
  constexpr size_t kHeader = 33;
  return png.substr(0, kHeader) + NumberBytes(block.size(), 4, false) + "eXIf" + block + "none" +
         png.substr(kHeader);
}

TEST(ExifOrientation, IsFoundInJpegPngAndTiff) {
  const testing::TempFolder folder;
  const cv::Mat image(48, 64, CV_8UC3, cv::Scalar(1, 2, 3));
  for (const std::string file : {"b.jpg", "b.png", "b.tiff"}) {
    cv::imwrite((folder / file).string(), image);
    EXPECT_EQ(FindExifOrientation(testing::ReadFile(folder / file)), 1) << file;
  }
  const std::string jpeg = testing::ReadFile(folder / "b.jpg"), png = testing::ReadFile(folder / "b.png");
  for (const bool is_little : {true, false}) {
    const std::string block = OrientationBlock(8, is_little);
    EXPECT_EQ(FindExifOrientation(block), 8);
    EXPECT_EQ(FindExifOrientation(JpegWithOrientation(jpeg, block)), 8);
    EXPECT_EQ(FindExifOrientation(PngWithOrientation(png, block)), 8);
    // Cut anywhere, or of no meaning.
    for (size_t length = 0; length < block.size(); ++length)
      EXPECT_LE(FindExifOrientation(JpegWithOrientation(jpeg, block.substr(0, length))), 8);
    EXPECT_EQ(FindExifOrientation(OrientationBlock(9, is_little)), 1);
  }
}

TEST_F(ImageTest, IsNotTurnedByItsOrientation) {
  const cv::Mat stored = *ReadImage(folder_ / "a.jpg").image;
  for (const bool is_little : {true, false}) {
    folder_.Write("turned.jpg",
                  JpegWithOrientation(testing::ReadFile(folder_ / "a.jpg"), OrientationBlock(6, is_little)));
    const ImageResult result = ReadImage(folder_ / "turned.jpg", camera_);
    ASSERT_TRUE(result.image) << result.error;
    EXPECT_EQ(result.orientation, 6);
    EXPECT_EQ(cv::norm(*result.image, stored, cv::NORM_INF), 0);
  }
  std::swap(camera_.width, camera_.height);
  ExpectError("turned.jpg", "EXIF orientation 6");
}

TEST_F(ImageTest, OfSixteenBitsIsStretchedFromTheBitsItHolds) {
  for (const int bits : {8, 10, 12, 14, 16}) {
    cv::Mat image(48, 64, CV_16UC1, cv::Scalar(0));
    const int most = (1 << bits) - 1;
    image.at<unsigned short>(3, 4) = static_cast<unsigned short>(most);
    image.at<unsigned short>(5, 6) = static_cast<unsigned short>(most / 2);
    cv::imwrite((folder_ / "deep.png").string(), image);
    const ImageResult result = ReadImage(folder_ / "deep.png", camera_);
    ASSERT_TRUE(result.image) << result.error;
    ASSERT_EQ(result.image->type(), CV_8UC3);
    EXPECT_EQ(result.image->at<cv::Vec3b>(3, 4), cv::Vec3b(255, 255, 255)) << bits;
    EXPECT_EQ(result.image->at<cv::Vec3b>(5, 6), cv::Vec3b(127, 127, 127)) << bits;
    EXPECT_EQ(result.image->at<cv::Vec3b>(0, 0), cv::Vec3b(0, 0, 0));
  }
}

TEST_F(ImageTest, OfRealNumbersGreyOrWithTransparencyBecomesEightBitsOfColour) {
  cv::imwrite((folder_ / "real.tiff").string(), cv::Mat(48, 64, CV_32FC3, cv::Scalar(0, 0.4, 1)));
  cv::imwrite((folder_ / "grey.png").string(), cv::Mat(48, 64, CV_8UC1, cv::Scalar(77)));
  cv::imwrite((folder_ / "clear.png").string(), cv::Mat(48, 64, CV_8UC4, cv::Scalar(10, 20, 30, 0)));
  const std::pair<std::string, cv::Vec3b> expected[] = {
      {"real.tiff", {0, 102, 255}}, {"grey.png", {77, 77, 77}}, {"clear.png", {10, 20, 30}}};
  for (const auto& [file, colour] : expected) {
    const ImageResult result = ReadImage(folder_ / file, camera_);
    ASSERT_TRUE(result.image) << result.error;
    ASSERT_EQ(result.image->type(), CV_8UC3);
    EXPECT_EQ(result.image->at<cv::Vec3b>(9, 9), colour) << file;
  }
}

TEST_F(ImageTest, ReportsAnotherSize) {
  camera_.width = 65;
  ExpectError("a.png", "64 x 48 pixels where the camera has 65 x 48");
}

}  // namespace
}  // namespace armature
