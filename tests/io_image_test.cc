// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

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

TEST_F(ImageTest, ReportsOtherFiles) {
  folder_.Write("text.jpg", "no image");
  folder_.Write("empty.png", "");
  ExpectError("text.jpg", "not a complete image");
  ExpectError("empty.png", "not a complete image");
  ExpectError("absent.png", "cannot be opened");
}

TEST_F(ImageTest, ReportsAnotherSize) {
  camera_.width = 65;
  ExpectError("a.png", "64 x 48 pixels where the camera has 65 x 48");
}

}  // namespace
}  // namespace armature
