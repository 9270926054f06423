// SPDX-License-Identifier: BSD-3-Clause
// Jobs of a small matrix, with a shell in the program's place.
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "app/reproduce/job_records.h"
#include "app/reproduce/job_scheduler.h"
#include "app/reproduce/reproduction_folder.h"
#include "base/interrupt.h"
#include "base/shell_text.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::ReadFile;
using testing::TempFolder;

class ReproduceJobs : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folders_.folder);
    std::filesystem::create_directories(folders_.finished);
  }
  // Writes its name to `calls` and to its output.
  Job Says(const std::string& name, const std::vector<std::string>& after = {}) const {
    return Calls(name, "echo " + name + " >>../calls; echo " + name + " >" + name, after);
  }
  Job Calls(const std::string& name, const std::string& script,
            const std::vector<std::string>& after = {}) const {
    return {.name = name, .commands = {{"-c", script}}, .outputs = {name}, .inputs = {}, .after = after};
  }
  std::vector<JobRecord> Run(const std::vector<Job>& jobs, int at_once = 2) {
    ContentHashes hashes;
    return RunJobs(jobs, folders_, at_once, hashes,
                   [&](const JobRecord& record) { ended_ += record.name + " "; });
  }
  std::string Calls() const { return ReadFile(folder_ / "calls"); }

  TempFolder folder_;
  JobFolders folders_{folder_ / "partial", folder_ / "finished", "/bin/sh"};
  std::string ended_;
};

TEST_F(ReproduceJobs, RunAfterWhatTheyNeed) {
  const auto records = Run({Says("c", {"b"}), Says("b", {"a"}), Says("a")});
  EXPECT_EQ(Calls(), "a\nb\nc\n");
  EXPECT_EQ(ended_, "a b c ");
  EXPECT_EQ(records[0].name, "c") << "records are in the order of the jobs";
  for (const JobRecord& record : records) EXPECT_EQ(record.status, JobStatus::kDone);
}

TEST_F(ReproduceJobs, AFailureIsTellingAndStopsOnlyWhatNeedsIt) {
  const auto records = Run({Calls("bad", "echo half >bad; echo 'armature: it broke' >&2; exit 2"),
                            Says("next", {"bad"}), Says("last", {"next"}), Says("other")});
  EXPECT_EQ(records[0].status, JobStatus::kFailed);
  EXPECT_EQ(records[0].reason, "it broke");
  EXPECT_FALSE(std::filesystem::exists(folders_.folder / "bad")) << "nothing half is left";
  EXPECT_EQ(records[1].status, JobStatus::kNotRun);
  EXPECT_EQ(records[1].reason, "needs bad");
  EXPECT_EQ(records[2].reason, "needs next");
  EXPECT_EQ(records[3].status, JobStatus::kDone);
}

TEST_F(ReproduceJobs, TellHowAProcessEndedThatSaidNothing) {
  EXPECT_EQ(Run({Calls("a", "exit 7")})[0].reason, "exit status 7");
  EXPECT_NE(Run({Calls("b", "kill -SEGV $$")})[0].reason.find("Segmentation"), std::string::npos);
  folders_.program = folder_ / "absent";
  EXPECT_NE(Run({Says("c")})[0].reason, "");
}

TEST_F(ReproduceJobs, ALaterCallOfAJobIsMadeOnlyWhenTheOneBeforeWentWell) {
  Job job = Says("a");
  job.commands.insert(job.commands.begin(), {"-c", "exit 1"});
  EXPECT_EQ(Run({job})[0].status, JobStatus::kFailed);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "calls"));
}

TEST_F(ReproduceJobs, AreNotRunAgain) {
  Run({Says("a")});
  const JobRecord again = Run({Says("a")})[0];
  EXPECT_EQ(again.status, JobStatus::kReused);
  EXPECT_EQ(Calls(), "a\n");
  EXPECT_EQ(Run({Says("a")})[0].status, JobStatus::kReused) << "nor a third time";
}

TEST_F(ReproduceJobs, AreTakenFromFinishedResults) {
  Run({Says("a")});
  std::filesystem::remove(folders_.finished);
  std::filesystem::rename(folders_.folder, folders_.finished);
  std::filesystem::create_directory(folders_.folder);
  EXPECT_EQ(Run({Says("a")})[0].status, JobStatus::kReused);
  EXPECT_EQ(ReadFile(folders_.folder / "a"), "a\n");
  EXPECT_EQ(ReadFile(folders_.finished / "a"), "a\n") << "copied, not moved";
}

TEST_F(ReproduceJobs, AreRunAgainWhenAnythingThatCountsIsOther) {
  Job job = Says("a");
  folder_.Write("partial/input/data.txt", "1");
  job.inputs = {"input"};
  EXPECT_EQ(Run({job})[0].status, JobStatus::kDone);
  EXPECT_EQ(Run({job})[0].status, JobStatus::kReused);
  folder_.Write("partial/input/data.txt", "2");
  EXPECT_EQ(Run({job})[0].status, JobStatus::kDone) << "an input's content";
  folder_.Write("partial/input/more.txt", "");
  EXPECT_EQ(Run({job})[0].status, JobStatus::kDone) << "an input's files";
  job.commands[0][1] += "; true";
  EXPECT_EQ(Run({job})[0].status, JobStatus::kDone) << "the command";
  std::filesystem::remove(folders_.folder / "a");
  EXPECT_EQ(Run({job})[0].status, JobStatus::kDone) << "an output is gone";
  folders_.program = "/bin/bash";
  EXPECT_EQ(Run({job})[0].status, JobStatus::kDone) << "the program";
  job.always = true;
  EXPECT_EQ(Run({job})[0].status, JobStatus::kDone);
}

TEST_F(ReproduceJobs, AMissingInputIsAFailureWithItsName) {
  Job job = Says("a");
  job.inputs = {"absent.txt"};
  const JobRecord record = Run({job})[0];
  EXPECT_EQ(record.status, JobStatus::kFailed);
  EXPECT_NE(record.reason.find("absent.txt"), std::string::npos) << record.reason;
}

TEST_F(ReproduceJobs, NothingRunsBesideOneThatIsAlone) {
  const std::string script = "echo begin >>../calls; sleep 0.05; echo end >>../calls; touch ";
  Job alone = Calls("b", script + "b");
  alone.alone = true;
  Run({Calls("a", script + "a"), alone, Calls("c", "touch c")}, 3);
  EXPECT_EQ(Calls(), "begin\nend\nbegin\nend\n");
}

TEST_F(ReproduceJobs, AnInterruptedOneIsToldToStopAndTheFinishedStay) {
  CatchInterrupts();
  const Job first = Says("a");
  const Job endless =
      Calls("b", "trap 'echo stopped >../calls; exit 130' INT; kill -INT $PPID; while :; do sleep 0.01; done",
            {"a"});
  EXPECT_THROW(Run({first, endless, Says("c", {"b"})}), Interrupted);
  EXPECT_EQ(Calls(), "stopped\n") << "it was waited for";
  EXPECT_TRUE(ReadRecord(folders_.folder, "a")->HasSucceeded());
  EXPECT_FALSE(ReadRecord(folders_.folder, "b"));
}

TEST(ReproduceRecords, ASpoiltOneIsNone) {
  const TempFolder folder;
  WriteRecord(folder.path(), {.name = "runs/a",
                              .status = JobStatus::kDone,
                              .seconds = 2,
                              .key = "k",
                              .reason = "",
                              .commands = {"x"}});
  EXPECT_EQ(ReadRecord(folder.path(), "runs/a")->key, "k");
  folder.Write("jobs/runs/a.json", "{\"job\": ");
  EXPECT_FALSE(ReadRecord(folder.path(), "runs/a"));
}

TEST(ReproduceFolder, IsOfOneProgramAtATimeAndPointedToWhenItIsDone) {
  const TempFolder root;
  {
    ReproductionFolder first(root.path(), "name");
    testing::ExpectInputError([&] { ReproductionFolder(root.path(), "name"); }, {"name", "another"});
    WriteEnvironment(first.partial(), 1, {});
    first.Publish();
  }
  EXPECT_TRUE(std::filesystem::equivalent(root / "latest", root / "name"));
  const ReproductionFolder again(root.path(), "name");
  EXPECT_TRUE(std::filesystem::is_empty(again.partial()));
}

TEST(ReproduceShellText, QuotesWhatAShellWouldChange) {
  EXPECT_EQ(ShellText({"run", "a b", "--set", "x=1", "it's", ""}),
            "armature run 'a b' --set x=1 'it'\\''s' ''");
}

}  // namespace
}  // namespace armature
