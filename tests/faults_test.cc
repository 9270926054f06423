// SPDX-License-Identifier: BSD-3-Clause
// What happens to the program from outside: killed at any moment, full and read-only disks, limits, closed
// streams, hang-ups. After each, an output is there whole or not at all, and the next call does it and leaves
// nothing aside.
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <optional>
#include <random>
#include <thread>

#include "base/child_process.h"
#include "datasets/cad/collection_files.h"
#include "support/filled_once.h"
#include "support/small_scene.h"

namespace armature {
namespace {

namespace fs = std::filesystem;
using testing::AllFiles;
using testing::ReadFile;
using testing::TempFolder;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

// What scripts/nightly.sh says, else what fits into scripts/test.sh.
int FromEnvironment(const char* name, int otherwise) {
  const char* value = std::getenv(name);
  return value == nullptr ? otherwise : std::stoi(value);
}

// A command, and what it makes in the folder of its output: each a file or a folder that is whole or absent.
struct Command {
  std::string name;
  std::vector<std::string> arguments;
  std::vector<std::string> outputs;
};

// A scene, a run of it and a library: what the commands are of.
void FillFolder(const TempFolder& folder) {
  testing::CopySmallScene(folder, 4);
  folder.Write("den_scene.yaml", testing::kSmallScene);
  testing::RunOk({"run", folder / "out/den", "--out", folder / "run", "--set", "mapping.min_observations=2"});
  std::vector<CadInstance> few = DrawCollection({.chairs = 0, .tables = 3, .laptops = 3});
  fs::create_directories(folder / "cad");
  WriteCollection(few, folder / "cad");
  testing::RunOk({"retrieve", "--build", "--cad", folder / "cad", "--out", folder / "furniture.armlib"});
  folder.Write("matrix.yaml", "name: den\nsequences: [" + (folder / "out/den").string() +
                                  "]\nvariants:\n  - {name: objects, about: all objects}\n");
  fs::create_directories(folder / "made");
}

class Faults : public ::testing::Test {
 protected:
  static const TempFolder& Folder() {
    static testing::FilledOnce filled(FillFolder);
    return filled.Restore();
  }

  // All output is in `made`. Retrieval changes a run: a copy of the run is there before.
  std::vector<Command> Commands(const fs::path& made) const {
    const std::string scene = folder_ / "out/den";
    return {{"run",
             {"run", scene, "--out", made / "run", "--overlays", "--video", made / "den.avi"},
             {"run", "den.avi"}},
            {"retrieve",
             {"retrieve", made / "retrieved", "--library", folder_ / "furniture.armlib", "--place"},
             {}},
            {"report", {"report", folder_ / "run", "--out", made / "report.html"}, {"report.html"}},
            {"generate",
             {"generate", "--scene", folder_ / "den_scene.yaml", "--without-cad", "--out", made / "data"},
             {"data/den", "data/contact_sheet.jpg"}},
            {"reproduce",
             {"reproduce", "--config", folder_ / "matrix.yaml", "--out", made / "results"},
             {"results/den"}}};
  }

  void Prepare(const Command& command, const fs::path& made) const {
    fs::create_directories(made);
    if (command.name == "retrieve")
      fs::copy(folder_ / "run", made / "retrieved", fs::copy_options::recursive);
  }

  const TempFolder& folder_ = Folder();
  const testing::StartedAnew anew_;  // its own file, signals and streams matter
};

ProgramCall Call(const std::vector<std::string>& arguments, const FileDescriptor& output) {
  return {.program = ARMATURE_PROGRAM,
          .arguments = arguments,
          .output = output.number(),
          .error_output = output.number()};
}

// The names written aside, wherever they are.
std::vector<std::string> Leftovers(const fs::path& folder) {
  std::vector<std::string> left;
  for (const std::string& file : AllFiles(folder)) {
    if (file.find(".partial") != std::string::npos) left.push_back(file);
  }
  return left;
}

// The first file that is missing of an output that is there, of the files that belong to it; empty: none is.
std::string MissingFile(const Command& command, const fs::path& made, const std::set<std::string>& all) {
  for (const std::string& output : command.outputs) {
    if (!fs::exists(made / output)) continue;
    for (const std::string& file : all) {
      if (file.starts_with(output) && !fs::exists(made / file)) return file;
    }
  }
  const bool has_table = fs::exists(made / "retrieved/retrieval.csv");
  for (const char* file : {"retrieved/map.ply", "retrieved/map.png"}) {
    if (fs::exists(made / file) != has_table) return file;
  }
  return "";
}

// Starts it and kills it after so many seconds, if it has not ended before.
void KillAfter(const std::vector<std::string>& arguments, double seconds, const fs::path& log) {
  const FileDescriptor output(log, O_WRONLY | O_CREAT | O_TRUNC);
  ChildProcess program(Call(arguments, output));
  std::this_thread::sleep_for(Seconds(seconds));
  program.Signal(SIGKILL);
  program.Wait();
}

TEST_F(Faults, KilledAtAnyMomentAnOutputIsWholeOrAbsentAndTheNextCallMakesIt) {
  const int kills = FromEnvironment("ARMATURE_KILLS", 1);
  std::mt19937 random(static_cast<unsigned>(FromEnvironment("ARMATURE_KILL_SEED", 1)));
  const fs::path whole = folder_ / "made/whole", made = folder_ / "made/killed";
  for (size_t c = 0; c < Commands(made).size(); ++c) {
    const Command command = Commands(made)[c];
    Prepare(command, whole);
    const Clock::time_point start = Clock::now();
    testing::RunOk(Commands(whole)[c].arguments);
    const double seconds = Seconds(Clock::now() - start).count();
    const std::set<std::string> all = AllFiles(whole);
    const bool is_long = command.name == "reproduce";
    for (int kill = 0; kill < (is_long ? (kills + 2) / 3 : kills); ++kill) {
      SCOPED_TRACE(fmt::format("{}, kill {}", command.name, kill));
      Prepare(command, made);
      KillAfter(command.arguments, std::uniform_real_distribution(0.0, seconds)(random), folder_ / "log");
      EXPECT_EQ(MissingFile(command, made, all), "");
      testing::RunOk(command.arguments);
      EXPECT_EQ(Leftovers(made), std::vector<std::string>{});
      EXPECT_EQ(AllFiles(made), all);
      fs::remove_all(made);
    }
    fs::remove_all(whole);
  }
}

// Does the work in a process that alone sees a small disk at `at`. None: that is not allowed here.
std::optional<int> OnDisk(const fs::path& at, const std::string& options, unsigned long flags,
                          const std::function<int()>& work) {
  constexpr int kNotAllowed = 77;
  fs::create_directories(at);
  ChildProcess child([&] {
    if (unshare(CLONE_NEWNS) != 0 || mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        mount("tmpfs", at.c_str(), "tmpfs", flags, options.c_str()) != 0)
      return kNotAllowed;
    return work();
  });
  const int status = child.Wait();
  return status == kNotAllowed ? std::nullopt : std::optional(status);
}

int Say(const std::string& what) {
  fmt::print(stderr, "{}\n", what);
  std::fflush(stderr);
  return 1;
}

// One line that names the reason, and nothing aside: 0; else it is told on standard error, and 1.
int CheckRefused(const testing::ProgramResult& result, const std::string& reason, const fs::path& made) {
  if (result.status != 2) return Say(fmt::format("status {}: {}", result.status, result.err));
  if (result.err.find(reason) == std::string::npos) return Say("another reason: " + result.err);
  if (!Leftovers(made).empty()) return Say("left: " + Leftovers(made).front());
  return 0;
}

// Leaves so many bytes on the small disk.
void FillDisk(const fs::path& disk, size_t free) {
  const size_t all = fs::space(disk).available;
  std::ofstream(disk / "filler") << std::string(all > free ? all - free : 0, 'x');
}

TEST_F(Faults, OnAFullDiskNothingIsHalfThereAndTheReasonIsSaid) {
  const fs::path disk = folder_ / "disk", made = disk / "made";
  const std::optional<int> status = OnDisk(disk, "size=8m", 0, [&] {
    for (const Command& command : Commands(made)) {
      for (const size_t free : {0, 16'000, 120'000}) {
        Prepare(command, made);
        FillDisk(disk, free);
        const testing::ProgramResult result = testing::RunProgram(command.arguments);
        const std::string which = fmt::format("{}, {} bytes free", command.name, free);
        if (result.status == 0) {
          if (!Leftovers(made).empty()) return Say(which + " left something aside");
        } else if (command.name != "reproduce" && CheckRefused(result, "No space left", made) != 0) {
          return Say(which);
        }
        for (const std::string& output : command.outputs) {
          // What reproduce could not run is a row of its results, which are whole.
          const bool may_be_there = command.name == "generate" || command.name == "reproduce";
          if (result.status != 0 && !may_be_there && fs::exists(made / output))
            return Say(which + " has " + output);
        }
        if (result.status != 0 && fs::exists(made / "retrieved/retrieval.csv")) return Say(which + ": mixed");
        fs::remove_all(made);
        fs::remove(disk / "filler");
      }
    }
    return 0;
  });
  if (!status) GTEST_SKIP() << "only root may have a small disk";
  EXPECT_EQ(*status, 0);
}

TEST_F(Faults, AVideoThatDoesNotFitIsNotThere) {
  const fs::path disk = folder_ / "video_disk";
  const std::optional<int> status = OnDisk(disk, "size=24k", 0, [&] {
    const auto result = testing::RunProgram(
        {"run", folder_ / "out/den", "--out", folder_ / "made/video_run", "--video", disk / "den.avi"});
    if (fs::exists(disk / "den.avi") || fs::exists(folder_ / "made/video_run")) return Say("half is there");
    return CheckRefused(result, "No space left", disk);
  });
  if (!status) GTEST_SKIP() << "only root may have a small disk";
  EXPECT_EQ(*status, 0);
}

TEST_F(Faults, AReadOnlyDiskIsSaidToBeOne) {
  const fs::path disk = folder_ / "read_only";
  const std::optional<int> status = OnDisk(disk, "size=1m", MS_RDONLY, [&] {
    const auto run = testing::RunProgram({"run", folder_ / "out/den", "--out", disk / "run"});
    const auto report = testing::RunProgram({"report", folder_ / "run", "--out", disk / "report.html"});
    return CheckRefused(run, "not read-only", disk) + CheckRefused(report, "not read-only", disk);
  });
  if (!status) GTEST_SKIP() << "only root may have a small disk";
  EXPECT_EQ(*status, 0);
}

// Through the shell: what it does to the streams.
int Shell(const std::vector<std::string>& arguments, const std::string& redirections) {
  std::string command = testing::ShellQuoted(ARMATURE_PROGRAM);
  for (const std::string& argument : arguments) command += " " + testing::ShellQuoted(argument);
  const int status = std::system((command + " " + redirections).c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(Faults, ClosedAndBrokenStreamsHarmNoOutput) {
  const std::vector<std::string> run{"run", folder_ / "out/den", "--out"};
  const auto run_to = [&](const std::string& name, const std::string& redirections) {
    std::vector<std::string> arguments = run;
    arguments.push_back(folder_ / "made" / name);
    return Shell(arguments, redirections);
  };
  EXPECT_EQ(run_to("closed", "<&- >&- 2>&-"), 0);
  EXPECT_EQ(run_to("nobody", "2>&1 | true"), 0);
  EXPECT_EQ(run_to("full", ">/dev/full 2>/dev/full"), 1) << "the table is lost";
  std::set<std::string> files = AllFiles(folder_ / "run");
  for (const char* name : {"closed", "nobody", "full"}) {
    EXPECT_EQ(AllFiles(folder_ / "made" / name), files) << name;
    EXPECT_TRUE(ReadFile(folder_ / "made" / name / "objects.csv").starts_with("id,category,")) << name;
  }
}

TEST_F(Faults, StandardOutputIsWrittenToAndNotReplaced) {
  const std::string link = folder_ / "made/stdout.png";
  fs::create_symlink("/dev/stdout", link);
  const std::vector<std::string> photo{"photo",    folder_ / "out/den/rgb/0000.jpg",
                                       "--camera", "130,130,80,60",
                                       "--box",    "table,20,20,100,80",
                                       "--out",    link};
  const std::string file = folder_ / "made/file.png";
  EXPECT_EQ(Shell(photo, "2>/dev/null | head -c 4 >" + testing::ShellQuoted(file)), 0);
  EXPECT_EQ(ReadFile(file), "\x89PNG");
  EXPECT_TRUE(fs::is_symlink(link));
}

}  // namespace
}  // namespace armature
