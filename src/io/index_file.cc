// SPDX-License-Identifier: BSD-3-Clause
#include "io/index_file.h"

#include <flann/config.h>
#include <fmt/format.h>

#include "base/checksum.h"
#include "base/errors.h"
#include "base/text.h"
#include "io/atomic_write.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

const std::string kIndexFormat = "armature-index ";
const std::string kIndexVersion = kIndexFormat + "1, FLANN " FLANN_VERSION_;
constexpr const char* kRebuild = "build it again with 'armature retrieve --build'";

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
  throw InputError(fmt::format("{}: {}; {}", file.string(), why, kRebuild));
}

void CheckIndexVersion(const fs::path& file, std::string_view line) {
  if (!line.starts_with(kIndexFormat)) Refuse(file, "is not an index of instances, or a damaged one");
  if (line != kIndexVersion) {
    Refuse(file, fmt::format("is of another version: {}, not {}", Quoted(std::string(line)),
                             Quoted(kIndexVersion)));
  }
}

}  // namespace

void WriteIndex(const InstanceIndex& index, const fs::path& file) {
  const std::string payload = index.Saved();
  std::string content;
  for (const std::string& line :
       {kIndexVersion, MethodLine(index.Description()), FeaturesLine(index.features()), PayloadLine(payload)})
    content += line + '\n';
  AtomicWrite(file, content + payload);
}

InstanceIndex ReadIndex(const fs::path& file, Eigen::MatrixXf features, const IndexMethod& method) {
  const std::string content = ReadTextFile(file);
  std::string_view rest = content;
  CheckIndexVersion(file, TakeLine(rest));
  const std::string_view built = TakeLine(rest);
  const std::string wanted = MethodLine(DescribeMethod(method));
  if (built != wanted) {
    Refuse(file, fmt::format("is of another method, or damaged: {}, not {}", Quoted(std::string(built)),
                             Quoted(wanted)));
  }
  if (TakeLine(rest) != FeaturesLine(features)) Refuse(file, "was built from other features, or is damaged");
  const std::string_view said = TakeLine(rest);
  if (said != PayloadLine(rest)) Refuse(file, "is damaged: cut short, or changed since it was written");
  try {
    return InstanceIndex::FromSaved(rest, std::move(features), method);
  } catch (const InputError& error) {
    Refuse(file, fmt::format("is damaged: {}", error.what()));
  }
}

}  // namespace armature
