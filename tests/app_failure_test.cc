// SPDX-License-Identifier: BSD-3-Clause
// What no exception of a library gets past, and input that is no file: one line and the right status.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <yaml-cpp/yaml.h>

#include <new>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "app/failure.h"
#include "base/errors.h"
#include "support/program.h"
#include "support/tiny_sequence.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

using testing::ExpectBadInput;

template <typename Error>
Failure FailureOf(const Error& error) {
  return DescribeFailure(std::make_exception_ptr(error));
}

TEST(Failures, HaveALineAndAStatusWhateverWasThrown) {
  const auto code = [](std::errc error) { return std::make_error_code(error); };
  EXPECT_EQ(FailureOf(InputError("a.txt: is empty")).status, 2);
  EXPECT_EQ(FailureOf(InputError("a.txt: is empty")).line, "a.txt: is empty");
  EXPECT_EQ(FailureOf(std::bad_alloc()).status, 1);
  EXPECT_NE(FailureOf(std::length_error("vector")).line.find("memory"), std::string::npos);
  EXPECT_NE(FailureOf(cv::Exception(cv::Error::StsNoMem, "", "", "", 1)).line.find("memory"),
            std::string::npos);
  EXPECT_EQ(FailureOf(cv::Exception(cv::Error::StsBadArg, "bad", "f", "x.cpp", 1)).line,
            "OpenCV failed: bad");
  const Failure loop =
      FailureOf(fs::filesystem_error("status", "a/b", code(std::errc::too_many_symbolic_link_levels)));
  EXPECT_EQ(loop.status, 2);
  EXPECT_TRUE(loop.line.starts_with("a/b: ")) << loop.line;
  EXPECT_EQ(FailureOf(fs::filesystem_error("write", "a", code(std::errc::no_space_on_device))).status, 1);
  EXPECT_EQ(FailureOf(YAML::Exception(YAML::Mark(), "bad")).status, 2);
  EXPECT_EQ(FailureOf(std::runtime_error("")).line.empty(), false);
  EXPECT_EQ(FailureOf(3).status, 1);
  try {
    nlohmann::json::parse("{").get<int>();
  } catch (...) {
    EXPECT_EQ(DescribeFailure(std::current_exception()).status, 2);
  }
}

class AppOddInput : public ::testing::Test {
 protected:
  AppOddInput() { WriteTinySequence(folder_); }
  std::vector<std::string> Run() const { return {"run", folder_.path(), "--out", folder_ / "run"}; }
  testing::TempFolder folder_;
};

TEST_F(AppOddInput, PipesDevicesFoldersAndLinksInACircleAreRefusedAtOnce) {
  for (const char* name : {"sequence.yaml", "rgb.txt", "detections.csv", "odometry.txt"}) {
    const fs::path file = folder_ / name, kept = folder_ / "kept";
    if (fs::exists(file)) fs::rename(file, kept);
    ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
    ExpectBadInput(Run(), {name, "pipe"});
    fs::remove(file);
    fs::create_directory(file);
    ExpectBadInput(Run(), {name, "is a folder"});
    fs::remove(file);
    fs::create_symlink("/dev/zero", file);
    ExpectBadInput(Run(), {name, "device"});
    fs::remove(file);
    fs::create_symlink(name, file);
    ExpectBadInput(Run(), {name, "symbolic links"});
    fs::remove(file);
    if (fs::exists(kept)) fs::rename(kept, file);
  }
  fs::remove(folder_ / "rgb/0.png");
  ASSERT_EQ(mkfifo((folder_ / "rgb/0.png").c_str(), 0600), 0);
  ExpectBadInput(Run(), {"rgb/0.png"});
}

TEST_F(AppOddInput, NamesThatAreNotPlainAreRefused) {
  for (const char* name : {"\"a\\e[31mred\"", "\"a\\nb\"", "\"a\\0b\""}) {
    folder_.Write("sequence.yaml", testing::TinySequenceYaml(name));
    ExpectBadInput(Run(), {"sequence.yaml:1", "'name'", "plain word"});
  }
}

TEST_F(AppOddInput, ControlCharactersOfPathsDoNotReachTheTerminal) {
  const fs::path odd = folder_ / "a\x1b[31mb";
  const testing::ProgramResult refused = testing::RunProgram({"run", odd, "--out", folder_ / "run"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.err.find('\x1b'), std::string::npos);
  EXPECT_NE(refused.err.find("a?[31mb"), std::string::npos) << refused.err;
  const testing::ProgramResult ran = testing::RunOk({"run", folder_.path(), "--out", odd});
  EXPECT_EQ((ran.out + ran.err).find('\x1b'), std::string::npos);
  EXPECT_NE(ran.out.find("a?[31mb"), std::string::npos) << ran.out;
  EXPECT_TRUE(fs::exists(odd / "summary.json"));
}

TEST_F(AppOddInput, AChoiceInLargeLettersIsUnderstoodAsMeant) {
  std::vector<std::string> arguments = Run();
  arguments.insert(arguments.end(), {"--set", "lines.detector=LSD"});
  ExpectBadInput(arguments, {"did you mean 'lsd'"});
}

TEST_F(AppOddInput, ADamagedConfigurationOrSummaryOfARunIsNamed) {
  testing::RunOk(Run());
  const fs::path good = folder_ / "run", bad = folder_ / "bad";
  fs::copy(good, bad, fs::copy_options::recursive);
  const std::string summary = testing::ReadFile(good / "summary.json");
  folder_.Write("bad/config.yaml", "resection: &a\n  x: *a\n");
  ExpectBadInput({"compare", good, bad}, {"config.yaml:2", "alias"});
  fs::copy_file(good / "config.yaml", bad / "config.yaml", fs::copy_options::overwrite_existing);
  folder_.Write("bad/summary.json", R"({"complete": true, "sequence": 3})");
  ExpectBadInput({"compare", good, bad}, {"summary.json", "'sequence'"});
  folder_.Write("bad/summary.json", R"({"complete": true, "sequence": "tiny", "machine": [1], "git": 3})");
  const testing::ProgramResult compared = testing::RunProgram({"compare", good, bad});
  EXPECT_EQ(compared.err.find("json.exception"), std::string::npos) << compared.err;
  EXPECT_NE(compared.status, -1);
}

}  // namespace
}  // namespace armature
