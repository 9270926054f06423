// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/sequence_pictures.h"

#include <opencv2/imgproc.hpp>

#include "base/errors.h"
#include "io/image.h"
#include "io/segments_csv.h"

namespace armature {
namespace {

cv::Mat3b DrawSegments(const std::vector<Segment>& segments, const Camera& camera) {
  cv::Mat3b picture(camera.height, camera.width, cv::Vec3b(255, 255, 255));
  const auto place = [](const Eigen::Vector2d& end) { return cv::Point2d(end.x(), end.y()); };
  for (const Segment& segment : segments)
    cv::line(picture, place(segment.p1), place(segment.p2), cv::Scalar(40, 40, 40), 2, cv::LINE_AA);
  return picture;
}

}  // namespace

SequencePictures::SequencePictures(const std::filesystem::path& sequence)
    : images_(ReadImageList(sequence / "rgb.txt")) {
  if (!images_.front().file.empty()) return;
  camera_ = ReadSequenceSettings(sequence / "sequence.yaml").camera;
  segments_ = ReadSegments(sequence / "segments.csv", images_);
}

cv::Mat SequencePictures::Read(size_t index) const {
  if (!segments_.empty()) return DrawSegments(segments_[index], camera_);
  const ImageResult read = ReadImage(images_[index].file);
  if (!read.image) throw InputError(read.error);
  return *read.image;
}

}  // namespace armature
