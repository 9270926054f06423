// SPDX-License-Identifier: BSD-3-Clause
#include "app/reproduce/job_records.h"

#include <fmt/format.h>
#include <string.h>  // NOLINT: strsignal is POSIX

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

#include "io/atomic_write.h"
#include "io/json_fields.h"
#include "io/json_file.h"

namespace armature {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array kNames{"done", "reused", "failed", "not run"};

fs::path RecordFile(const fs::path& folder, const std::string& job) {
  return folder / "jobs" / (job + ".json");
}

JobStatus ParseStatus(const std::string& name) {
  for (size_t i = 0; i < kNames.size(); ++i) {
    if (name == kNames[i]) return static_cast<JobStatus>(i);
  }
  return JobStatus::kNotRun;
}

}  // namespace

std::string StatusName(JobStatus status) { return kNames.at(static_cast<size_t>(status)); }

fs::path LogFile(const fs::path& folder, const std::string& job) { return folder / "jobs" / (job + ".log"); }

void WriteRecord(const fs::path& folder, const JobRecord& record) {
  const Json json{{"job", record.name},        {"status", StatusName(record.status)},
                  {"seconds", record.seconds}, {"key", record.key},
                  {"reason", record.reason},   {"commands", record.commands}};
  AtomicWrite(RecordFile(folder, record.name),
              json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<JobRecord> ReadRecord(const fs::path& folder, const std::string& job) {
  const std::optional<Json> json = FindJsonObject(RecordFile(folder, job));
  if (!json) return std::nullopt;
  try {
    if (JsonFieldOr<std::string>(*json, "job", "") != job) return std::nullopt;
    return JobRecord{.name = job,
                     .status = ParseStatus(JsonFieldOr<std::string>(*json, "status", "")),
                     .seconds = JsonFieldOr(*json, "seconds", 0.0),
                     .key = JsonFieldOr<std::string>(*json, "key", ""),
                     .reason = JsonFieldOr<std::string>(*json, "reason", ""),
                     .commands = JsonFieldOr(*json, "commands", std::vector<std::string>{})};
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::string FindReason(const fs::path& log, int ended) {
  const std::string start = "armature: ";
  std::string reason;
  std::ifstream stream(log);  // our own: it may be cut anywhere
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with(start)) reason = line.substr(start.size());
  }
  if (ended < 0) return fmt::format("ended by a signal ({})", strsignal(-ended));
  return reason.empty() ? fmt::format("exit status {}", ended) : reason;
}

}  // namespace armature
