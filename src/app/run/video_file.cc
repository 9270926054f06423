// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/video_file.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

#include "app/run/video_module.h"
#include "base/errors.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

// Beside the program where it is built, in the folder of libraries where it is installed.
void* LoadVideoModule() {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
  for (const char* place : {".", "../lib/armature"}) {
    const fs::path module = program / place / "armature_video.so";
    if (!fs::exists(module)) continue;
    if (void* loaded = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL)) return loaded;
    throw std::runtime_error(fmt::format("the part that writes videos cannot be loaded: {}", dlerror()));
  }
  throw std::runtime_error(fmt::format(
      "{}: armature_video.so, which writes videos, is not beside the program; build it", program.string()));
}

// Of the same ending: that says which kind of file it is.
fs::path Aside(const fs::path& file) {
  fs::path aside = file;
  return aside.replace_extension(".partial" + file.extension().string());
}

void CreateFolder(const fs::path& file) {
  std::error_code error;  // shows when the video cannot be opened
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
}

}  // namespace

// Never unloaded: ffmpeg's libraries have threads of their own.
struct VideoFile::Module {
  void* loaded = LoadVideoModule();
  decltype(&ArmatureOpenVideo) open = Find<decltype(&ArmatureOpenVideo)>("ArmatureOpenVideo");
  decltype(&ArmatureAddFrame) add = Find<decltype(&ArmatureAddFrame)>("ArmatureAddFrame");
  decltype(&ArmatureCloseVideo) close = Find<decltype(&ArmatureCloseVideo)>("ArmatureCloseVideo");

  template <typename Function>
  Function Find(const char* name) const {
    return reinterpret_cast<Function>(dlsym(loaded, name));
  }
};

void CheckVideoName(const fs::path& file) {
  if (file.extension() == ".mp4" || file.extension() == ".avi") return;
  throw InputError(fmt::format("{}: the name of a video has to end with .mp4 or .avi", file.string()));
}

VideoFile::VideoFile(const fs::path& file, double fps, const cv::Size& size)
    : file_(file), aside_(Aside(file)) {
  CheckVideoName(file);
  module_ = std::make_unique<Module>();
  CreateFolder(file);
  video_ = module_->open(aside_.c_str(), fps, size.width, size.height);
  if (video_ != nullptr) return;
  std::error_code ignored;
  fs::remove(aside_, ignored);
  throw InputError(
      fmt::format("{}: cannot be written; choose a folder that may be written, or .avi where this OpenCV has "
                  "no encoder for .mp4",
                  file.string()));
}

VideoFile::~VideoFile() {
  if (video_ == nullptr) return;
  module_->close(video_);
  std::error_code ignored;
  fs::remove(aside_, ignored);
}

void VideoFile::Add(const cv::Mat& frame) { module_->add(video_, &frame); }

void VideoFile::Publish() {
  module_->close(video_);
  video_ = nullptr;
  std::error_code error;
  fs::rename(aside_, file_, error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(aside_, ignored);
  throw InputError(
      fmt::format("{}: cannot be written ({}); choose another name", file_.string(), error.message()));
}

}  // namespace armature
