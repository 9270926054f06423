// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/contact_sheet.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "base/errors.h"
#include "io/image.h"
#include "io/sequence.h"

namespace armature {
namespace {

// `count` pictures evenly over the sequence, of the given width; fewer when it has fewer.
std::vector<cv::Mat3b> Thumbnails(const std::filesystem::path& sequence, int count, int width) {
  const std::vector<ImageEntry> images = ReadImageList(sequence / "rgb.txt");
  const size_t wanted = std::min(static_cast<size_t>(count), images.size());
  std::vector<cv::Mat3b> thumbnails;
  for (size_t i = 0; i < wanted; ++i) {
    const ImageResult read = ReadImage(images[i * images.size() / wanted].file);
    if (!read.image) throw InputError(read.error);
    const cv::Mat& image = *read.image;
    cv::Mat3b small;
    cv::resize(image, small, {width, width * image.rows / image.cols}, 0, 0, cv::INTER_AREA);
    thumbnails.push_back(small);
  }
  return thumbnails;
}

// Below `sheet`, with a margin.
void Append(const std::vector<cv::Mat3b>& thumbnails, const ContactSheetOptions& options, cv::Mat3b* sheet) {
  const int step_x = options.width_px + options.margin_px,
            step_y = thumbnails.front().rows + options.margin_px;
  const int columns = options.columns;
  const int rows = (static_cast<int>(thumbnails.size()) + columns - 1) / columns;
  cv::Mat3b block(rows * step_y, columns * step_x + options.margin_px, cv::Vec3b(255, 255, 255));
  for (int i = 0; i < static_cast<int>(thumbnails.size()); ++i) {
    const cv::Mat3b& picture = thumbnails[static_cast<size_t>(i)];
    picture.copyTo(block(cv::Rect(options.margin_px + i % columns * step_x, i / columns * step_y,
                                  picture.cols, picture.rows)));
  }
  sheet->push_back(block);
}

}  // namespace

cv::Mat3b ContactSheet(const std::vector<std::filesystem::path>& sequences,
                       const ContactSheetOptions& options) {
  cv::Mat3b sheet(options.margin_px,
                  options.columns * (options.width_px + options.margin_px) + options.margin_px,
                  cv::Vec3b(255, 255, 255));
  for (const std::filesystem::path& sequence : sequences)
    Append(Thumbnails(sequence, options.columns * options.rows, options.width_px), options, &sheet);
  return sheet;
}

}  // namespace armature
