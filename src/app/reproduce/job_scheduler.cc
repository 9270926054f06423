// SPDX-License-Identifier: BSD-3-Clause
#include "app/reproduce/job_scheduler.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <thread>

#include "app/reproduce/job_records.h"
#include "base/child_process.h"
#include "base/errors.h"
#include "base/interrupt.h"
#include "base/shell_text.h"

namespace armature {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kBetweenLooks{20};

// A job whose calls are being made.
struct RunningJob {
  size_t index = 0;
  size_t command = 0;  // the call that runs
  std::unique_ptr<ChildProcess> process;
  Clock::time_point start = Clock::now();
};

class Scheduler {
 public:
  Scheduler(const std::vector<Job>& jobs, const JobFolders& folders, ContentHashes& hashes,
            const std::function<void(const JobRecord&)>& on_end)
      : jobs_(jobs), folders_(folders), hashes_(hashes), on_end_(on_end), records_(jobs.size()) {
    for (size_t i = 0; i < jobs.size(); ++i) index_[jobs[i].name] = i;
  }

  std::vector<JobRecord> Run(size_t at_once) {
    while (ended_ < jobs_.size()) {
      ThrowIfInterrupted();
      while (running_.size() < at_once && StartNext()) continue;
      if (!LookAfter()) std::this_thread::sleep_for(kBetweenLooks);
    }
    std::vector<JobRecord> records;
    for (std::optional<JobRecord>& record : records_) records.push_back(std::move(*record));
    return records;
  }

 private:
  // Starts or ends one job that waits. False: none can be, for now.
  bool StartNext() {
    if (std::any_of(running_.begin(), running_.end(), [&](auto& r) { return jobs_[r.index].alone; }))
      return false;
    for (size_t i = 0; i < jobs_.size(); ++i) {
      if (records_[i] || IsRunning(i) || !AreEnded(jobs_[i].after)) continue;
      if (jobs_[i].alone && !running_.empty()) continue;
      Begin(i);
      return true;
    }
    return false;
  }

  bool IsRunning(size_t index) const {
    return std::any_of(running_.begin(), running_.end(), [&](const auto& r) { return r.index == index; });
  }

  bool AreEnded(const std::vector<std::string>& names) const {
    return std::all_of(names.begin(), names.end(),
                       [&](const std::string& name) { return records_[index_.at(name)].has_value(); });
  }

  void Begin(size_t index) {
    const Job& job = jobs_[index];
    JobRecord record{.name = job.name};
    for (const auto& command : job.commands) record.commands.push_back(ShellText(command));
    for (const std::string& needed : job.after) {
      if (records_[index_.at(needed)]->HasSucceeded()) continue;
      record.reason = "needs " + needed;
      return End(index, record);
    }
    try {
      record.key = MakeKey(job, folders_.folder, folders_.program, hashes_);
      if (const auto earlier = Reused(job, record.key)) return End(index, *earlier);
      Prepare(job);
      started_[index] = record;
      running_.push_back({.index = index, .process = Start(job, 0)});
    } catch (const std::exception& error) {
      Fail(index, record, error.what());
    }
  }

  std::unique_ptr<ChildProcess> Start(const Job& job, size_t command) const {
    const FileDescriptor log(LogFile(folders_.folder, job.name), O_WRONLY | O_CREAT | O_APPEND);
    return std::make_unique<ChildProcess>(ProgramCall{.program = folders_.program,
                                                      .arguments = job.commands[command],
                                                      .folder = folders_.folder,
                                                      .output = log.number(),
                                                      .error_output = log.number()});
  }

  // Nothing of an earlier try is left.
  void Prepare(const Job& job) const {
    for (const std::string& output : job.outputs) fs::remove_all(folders_.folder / output);
    fs::create_directories(LogFile(folders_.folder, job.name).parent_path());
    fs::remove(LogFile(folders_.folder, job.name));
  }

  // The record of the finished job with this key, whose outputs are then in the folder.
  std::optional<JobRecord> Reused(const Job& job, const std::string& key) const {
    if (job.always) return std::nullopt;
    for (const fs::path& where : {folders_.folder, folders_.finished}) {
      std::optional<JobRecord> record = where.empty() ? std::nullopt : ReadRecord(where, job.name);
      if (!record || !record->HasSucceeded() || record->key != key || !HasOutputs(job, where)) continue;
      if (where != folders_.folder) CopyFrom(where, job);
      record->status = JobStatus::kReused;
      return record;
    }
    return std::nullopt;
  }

  bool HasOutputs(const Job& job, const fs::path& where) const {
    return std::all_of(job.outputs.begin(), job.outputs.end(),
                       [&](const std::string& output) { return fs::exists(where / output); });
  }

  void CopyFrom(const fs::path& where, const Job& job) const {
    Prepare(job);
    for (const std::string& output : job.outputs) {
      fs::create_directories((folders_.folder / output).parent_path());
      fs::copy(where / output, folders_.folder / output, fs::copy_options::recursive);
    }
    if (fs::exists(LogFile(where, job.name)))
      fs::copy(LogFile(where, job.name), LogFile(folders_.folder, job.name));
  }

  // Takes note of calls that have ended. False: none has.
  bool LookAfter() {
    for (auto job = running_.begin(); job != running_.end(); ++job) {
      const std::optional<int> ended = job->process->Ended();
      if (!ended) continue;
      if (!Continue(*job, *ended)) running_.erase(job);
      return true;
    }
    return false;
  }

  // Makes the next call of the job. False: there is none, the job has ended.
  bool Continue(RunningJob& running, int ended) {
    const Job& job = jobs_[running.index];
    JobRecord record = started_.at(running.index);
    record.seconds = std::chrono::duration<double>(Clock::now() - running.start).count();
    if (ended != 0) {
      Fail(running.index, record, FindReason(LogFile(folders_.folder, job.name), ended));
      return false;
    }
    if (++running.command < job.commands.size()) return StartAgain(running, record);
    record.status = JobStatus::kDone;
    End(running.index, record);
    return false;
  }

  bool StartAgain(RunningJob& running, const JobRecord& record) {
    try {
      running.process = Start(jobs_[running.index], running.command);
      return true;
    } catch (const std::exception& error) {
      Fail(running.index, record, error.what());
      return false;
    }
  }

  void Fail(size_t index, JobRecord record, const std::string& reason) {
    record.status = JobStatus::kFailed;
    record.reason = reason;
    record.key.clear();
    for (const std::string& output : jobs_[index].outputs) fs::remove_all(folders_.folder / output);
    End(index, record);
  }

  void End(size_t index, const JobRecord& record) {
    WriteRecord(folders_.folder, record);
    records_[index] = record;
    ++ended_;
    on_end_(record);
  }

  const std::vector<Job>& jobs_;
  const JobFolders& folders_;
  ContentHashes& hashes_;
  const std::function<void(const JobRecord&)>& on_end_;
  std::map<std::string, size_t> index_;  // by name
  std::vector<std::optional<JobRecord>> records_;
  std::map<size_t, JobRecord> started_;
  std::list<RunningJob> running_;
  size_t ended_ = 0;
};

}  // namespace

std::vector<JobRecord> RunJobs(const std::vector<Job>& jobs, const JobFolders& folders, int at_once,
                               ContentHashes& hashes, const std::function<void(const JobRecord&)>& on_end) {
  return Scheduler(jobs, folders, hashes, on_end).Run(static_cast<size_t>(std::max(at_once, 1)));
}

}  // namespace armature
