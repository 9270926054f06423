// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "bench/keypoints/heat_maps.h"

namespace armature {
namespace {

const Box kHeatMapCrop{100, 50, 128, 128};  // a map pixel is two pixels of the image

// Where the image sees the map's point.
Eigen::Vector2d InImage(double x, double y) { return {100 + 2 * (x + 0.5), 50 + 2 * (y + 0.5)}; }

Peak PeakOf(const Eigen::Vector2d& pixel) {
  return ReadPeaks(DrawHeatMaps({pixel}, kHeatMapCrop), kHeatMapCrop).front();
}

TEST(HeatMaps, AKeypointAtAMapPixelsCentreIsReadExactly) {
  const Peak peak = PeakOf(InImage(20, 41));
  EXPECT_LT((peak.pixel - InImage(20, 41)).norm(), 1e-12);
  EXPECT_DOUBLE_EQ(peak.score, 1);
}

TEST(HeatMaps, APeakMovesAQuarterTowardsItsLargerNeighbour) {
  EXPECT_LT((PeakOf(InImage(20.1, 41)).pixel - InImage(20.25, 41)).norm(), 1e-12);
  EXPECT_LT((PeakOf(InImage(19.6, 41.3)).pixel - InImage(19.75, 41.25)).norm(), 1e-12);
}

TEST(HeatMaps, KeypointsAreReadToAQuarterOfAMapPixel) {
  for (double offset = -0.45; offset < 0.5; offset += 0.1) {
    const Eigen::Vector2d truth = InImage(30 + offset, 12 - offset);
    EXPECT_LE((PeakOf(truth).pixel - truth).cwiseAbs().maxCoeff(), 2 * 0.25 + 1e-9) << offset;
  }
}

TEST(HeatMaps, APeakAtTheBorderStaysWhereItIs) {
  EXPECT_LT((PeakOf(InImage(0.3, 63.2)).pixel - InImage(0, 63)).norm(), 1e-12);
}

TEST(HeatMaps, AKeypointOutsideOfTheCropHasNoScore) {
  EXPECT_EQ(PeakOf({99, 100}).score, 0);
  EXPECT_EQ(PeakOf({150, 180}).score, 0);
}

TEST(HeatMaps, EachKeypointHasItsMap) {
  const cv::Mat maps = DrawHeatMaps({InImage(5, 6), {0, 0}, InImage(50, 40)}, kHeatMapCrop);
  EXPECT_EQ(maps.size(), cv::Size(64, 3 * 64));
  const std::vector<Peak> peaks = ReadPeaks(maps, kHeatMapCrop);
  ASSERT_EQ(peaks.size(), 3u);
  EXPECT_LT((peaks[0].pixel - InImage(5, 6)).norm(), 1e-12);
  EXPECT_EQ(peaks[1].score, 0);
  EXPECT_LT((peaks[2].pixel - InImage(50, 40)).norm(), 1e-12);
}

TEST(HeatMaps, TheCropIsASquareAboutTheBox) {
  const Box crop = CropAround({10, 20, 40, 80});
  EXPECT_EQ(crop.width, 100);
  EXPECT_EQ(crop.height, 100);
  EXPECT_EQ(crop.center(), Eigen::Vector2d(30, 60));
}

TEST(HeatMaps, ThePictureShowsTheCropAndNothingBeyondTheImage) {
  cv::Mat gray(60, 80, CV_8U);
  for (int v = 0; v < gray.rows; ++v) {
    for (int u = 0; u < gray.cols; ++u) gray.at<uchar>(v, u) = static_cast<uchar>(10 + 2 * u + v);
  }
  // Half a picture's pixel is a quarter of the image's: columns 4i + 2 of the image from -8 on.
  const cv::Mat picture = CropPicture(gray, {-8, -8, 64, 64}, 16);
  ASSERT_EQ(picture.type(), CV_8UC3);
  ASSERT_EQ(picture.size(), cv::Size(16, 16));
  EXPECT_EQ(picture.at<cv::Vec3b>(5, 0), cv::Vec3b(0, 0, 0));
  EXPECT_EQ(picture.at<cv::Vec3b>(0, 5), cv::Vec3b(0, 0, 0));
  EXPECT_EQ(picture.at<cv::Vec3b>(5, 4), cv::Vec3b::all(10 + 2 * 10 + 14));
}

}  // namespace
}  // namespace armature
