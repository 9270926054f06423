// SPDX-License-Identifier: BSD-3-Clause
#include "io/index_file.h"

#include <flann/config.h>
#include <fmt/format.h>

#include "io/checksum.h"
#include "io/errors.h"
#include "io/text.h"
#include "io/whole_file.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

const std::string kFormat = "armature-index ";
const std::string kVersion = kFormat + "1, FLANN " FLANN_VERSION_;
constexpr const char* kRemedy = "build it again with 'armature retrieve --build'";

std::string MethodLine(const std::string& method) { return "method " + method; }

std::string FeaturesLine(const Eigen::MatrixXf& features) {
  const std::span<const float> numbers(features.data(), static_cast<size_t>(features.size()));
  return fmt::format("features {} x {}, checksum {:016x}", features.rows(), features.cols(),
                     Checksum(std::as_bytes(numbers)));
}

std::string PayloadLine(std::string_view payload) {
  return fmt::format("payload {} bytes, checksum {:016x}", payload.size(),
                     Checksum(std::as_bytes(std::span(payload))));
}

// Takes the next line from the content; what is left of a file that is cut short.
std::string_view TakeLine(std::string_view& content) {
  const size_t end = content.find('\n');
  const std::string_view line = content.substr(0, end);
  content.remove_prefix(end == std::string_view::npos ? content.size() : end + 1);
  return line;
}

[[noreturn]] void Refuse(const fs::path& file, const std::string& why) {
  throw InputError(fmt::format("{}: {}; {}", file.string(), why, kRemedy));
}

void CheckVersion(const fs::path& file, std::string_view line) {
  if (!line.starts_with(kFormat)) Refuse(file, "is not an index of instances, or a damaged one");
  if (line != kVersion) {
    Refuse(file,
           fmt::format("is of another version: {}, not {}", Quoted(std::string(line)), Quoted(kVersion)));
  }
}

}  // namespace

void WriteIndexFile(const fs::path& file, const std::string& method, const Eigen::MatrixXf& features,
                    const std::string& payload) {
  std::string content;
  for (const std::string& line : {kVersion, MethodLine(method), FeaturesLine(features), PayloadLine(payload)})
    content += line + '\n';
  WriteWholeFile(file, content + payload);
}

std::string ReadIndexFile(const fs::path& file, const std::string& method, const Eigen::MatrixXf& features) {
  std::string content = ReadTextFile(file);
  std::string_view rest = content;
  CheckVersion(file, TakeLine(rest));
  const std::string_view built = TakeLine(rest);
  if (built != MethodLine(method)) {
    Refuse(file, fmt::format("is of another method, or damaged: {}, not {}", Quoted(std::string(built)),
                             Quoted(MethodLine(method))));
  }
  if (TakeLine(rest) != FeaturesLine(features)) Refuse(file, "was built from other features, or is damaged");
  const std::string_view said = TakeLine(rest);
  if (said != PayloadLine(rest)) Refuse(file, "is damaged: cut short, or changed since it was written");
  return content.erase(0, content.size() - rest.size());
}

}  // namespace armature
