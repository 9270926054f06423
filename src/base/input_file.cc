// SPDX-License-Identifier: BSD-3-Clause
#include "base/input_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <string_view>

#include "base/errors.h"

namespace armature {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{4} << 30;  // a library of 20 million chairs
constexpr size_t kChunk = size_t{1} << 20;

[[noreturn]] void Refuse(const std::filesystem::path& file, std::string_view why) {
  throw InputError(fmt::format("{}: {}", file.string(), why));
}

class Descriptor {
 public:
  // Without waiting, which opening a pipe would do.
  explicit Descriptor(const std::filesystem::path& file)
      : number_(open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY)) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

[[noreturn]] void RefuseUnopened(const std::filesystem::path& file, int error) {
  if (error == ELOOP) Refuse(file, "is a circle of symbolic links; name a file");
  if (error == EMFILE || error == ENFILE) Refuse(file, "cannot be opened: too many files are open");
  Refuse(file, "cannot be opened; check that it exists and may be read");
}

void CheckKind(const std::filesystem::path& file, const struct stat& status) {
  if (S_ISREG(status.st_mode)) return;
  if (S_ISDIR(status.st_mode)) Refuse(file, "is a folder; name a file");
  Refuse(file, "is no regular file but a pipe, a socket or a device; write its content to a file");
}

void CheckSize(const std::filesystem::path& file, std::uint64_t bytes) {
  if (bytes <= kMostBytes) return;
  Refuse(file, fmt::format("is larger than {} GB; give a smaller file", kMostBytes >> 30));
}

}  // namespace

std::string ReadInputFile(const std::filesystem::path& file) {
  struct stat status {};
  // Before it is opened: opening a device may do something.
  if (stat(file.c_str(), &status) != 0) RefuseUnopened(file, errno);
  CheckKind(file, status);
  const Descriptor descriptor(file);
  if (descriptor.number() < 0 || fstat(descriptor.number(), &status) != 0) RefuseUnopened(file, errno);
  CheckKind(file, status);
  CheckSize(file, static_cast<std::uint64_t>(status.st_size));
  // One byte more than there should be: the end is then found without growing. /proc says 0.
  std::string content(static_cast<size_t>(status.st_size) + 1, '\0');
  size_t size = 0;
  while (true) {
    if (size == content.size()) content.resize(size + std::max(size / 2, kChunk));
    const ssize_t got = read(descriptor.number(), content.data() + size, content.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) Refuse(file, "cannot be read to its end; copy it again");
    if (got == 0) break;
    size += static_cast<size_t>(got);
    CheckSize(file, size);
  }
  content.resize(size);
  return content;
}

}  // namespace armature
