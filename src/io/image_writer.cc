// SPDX-License-Identifier: BSD-3-Clause
#include "io/image_writer.h"

#include <fmt/format.h>

#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "base/errors.h"
#include "io/atomic_write.h"

namespace armature {
namespace {

constexpr int kJpegQuality = 95;

}  // namespace

void CheckPictureName(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".png" || ending == ".jpg" || ending == ".jpeg") return;
  throw InputError(fmt::format("{}: is no name of a picture; let it end in .png or .jpg", file.string()));
}

void WritePicture(const std::filesystem::path& file, const cv::Mat& picture) {
  CheckPictureName(file);
  std::vector<unsigned char> bytes;
  cv::imencode(file.extension().string(), picture, bytes, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  AtomicWrite(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace armature
