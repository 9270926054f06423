// SPDX-License-Identifier: BSD-3-Clause
#include "io/image_writer.h"

#include <fmt/format.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "io/errors.h"

namespace armature {
namespace {

constexpr int kJpegQuality = 95;

[[noreturn]] void ThrowUnwritable(const std::filesystem::path& file) {
  throw InputError(fmt::format("{}: cannot be written; choose a folder that may be written", file.string()));
}

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
  std::error_code failed;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), failed);
  std::filesystem::path partial = file;
  partial += ".partial";
  std::ofstream stream(partial, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (stream) std::filesystem::rename(partial, file, failed);
  if (stream && !failed) return;
  std::filesystem::remove(partial, failed);
  ThrowUnwritable(file);
}

}  // namespace armature
