// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/video_file.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <stdexcept>

#include "app/run/video_module.h"
#include "base/child_process.h"
#include "base/errors.h"
#include "base/write_failure.h"
#include "io/atomic_write.h"

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

// Encoders go to and fro in it.
void CheckIsRegular(const fs::path& file) {
  std::error_code absent;
  const fs::file_status status = fs::status(file, absent);
  if (!fs::exists(status) || fs::is_regular_file(status)) return;
  throw InputError(
      fmt::format("{}: is no regular file, and a video needs one; choose another name", file.string()));
}

// Why nothing more can be written there; 0: it can.
int FindWriteError(const fs::path& file) {
  constexpr size_t kAsMuchAsAFrame = 1 << 20;
  const FileDescriptor opened(open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  const std::string bytes(kAsMuchAsAFrame, '\0');
  if (opened.number() < 0) return errno;
  const ssize_t written = write(opened.number(), bytes.data(), bytes.size());
  if (written < 0) return errno;
  return static_cast<size_t>(written) < bytes.size() ? ENOSPC : 0;
}

}  // namespace

// Never unloaded: ffmpeg's libraries have threads of their own.
struct VideoFile::Module {
  void* loaded = LoadVideoModule();
  decltype(&ArmatureOpenVideo) open = Find<decltype(&ArmatureOpenVideo)>("ArmatureOpenVideo");
  decltype(&ArmatureAddFrame) add = Find<decltype(&ArmatureAddFrame)>("ArmatureAddFrame");
  decltype(&ArmatureCloseVideo) close = Find<decltype(&ArmatureCloseVideo)>("ArmatureCloseVideo");
  decltype(&ArmatureCountFrames) count = Find<decltype(&ArmatureCountFrames)>("ArmatureCountFrames");

  template <typename Function>
  Function Find(const char* name) const {
    return reinterpret_cast<Function>(dlsym(loaded, name));
  }
};

void CheckVideoName(const fs::path& file) {
  if (file.extension() == ".mp4" || file.extension() == ".avi") return;
  throw InputError(fmt::format("{}: the name of a video has to end with .mp4 or .avi", file.string()));
}

VideoFile::VideoFile(const fs::path& file, double fps, const cv::Size& size) : file_(BehindLinks(file)) {
  CheckVideoName(file);
  CheckVideoName(file_);
  CheckIsRegular(file_);
  module_ = std::make_unique<Module>();
  aside_ = Aside(file_);
  WriteFile(aside_, "");  // says why it cannot be
  video_ = module_->open(aside_.c_str(), fps, size.width, size.height);
  if (video_ != nullptr) return;
  const int error = FindWriteError(aside_);
  fs::remove(aside_);
  if (error != 0) throw InputError(WriteFailure(file_, error));
  throw InputError(fmt::format("{}: this OpenCV has no encoder for {}; choose the other of .mp4 and .avi",
                               file_.string(), file_.extension().string()));
}

VideoFile::~VideoFile() {
  Close();
  std::error_code ignored;
  if (!aside_.empty()) fs::remove(aside_, ignored);
}

void VideoFile::Close() {
  if (video_ != nullptr) module_->close(video_);
  video_ = nullptr;
}

void VideoFile::Add(const cv::Mat& frame) {
  module_->add(video_, &frame);
  ++frames_;
}

void VideoFile::Finish() {
  Close();
  if (module_->count(aside_.c_str()) == frames_) return;
  throw InputError(WriteFailure(file_, FindWriteError(aside_)));
}

void VideoFile::Publish() {
  const FileDescriptor written(open(aside_.c_str(), O_RDONLY | O_CLOEXEC));
  if (fsync(written.number()) != 0 || std::rename(aside_.c_str(), file_.c_str()) != 0)
    throw InputError(WriteFailure(file_, errno));
  aside_.clear();
  SyncFolder(file_.parent_path());
}

}  // namespace armature
