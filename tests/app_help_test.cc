// SPDX-License-Identifier: BSD-3-Clause
// What the program says of itself: help whose examples are right, and completion in a real bash.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "app/commands.h"
#include "base/console.h"
#include "cli/help.h"
#include "cli/wrapped_text.h"
#include "support/program.h"

namespace armature {
namespace {

using testing::RunOk;

// The program's commands; parsing ends with CLI::Success before any of them does anything.
struct IdleProgram {
  CLI::App app{"", "armature"};
  int status = 0;
  std::vector<CLI::App*> commands;

  IdleProgram() {
    AddCommands(app, status);
    commands = app.get_subcommands([](CLI::App*) { return true; });
    app.parse_complete_callback([] { throw CLI::Success(); });
  }
};

// The lines below "Examples:" that are no comments, joined where they go on.
std::vector<std::string> ExamplesIn(const std::string& help) {
  std::istringstream lines(help.substr(help.find("\nExamples:\n") + 1));
  std::vector<std::string> examples;
  std::string line;
  std::getline(lines, line);
  for (bool goes_on = false; std::getline(lines, line) && line.starts_with("  ");) {
    if (line.starts_with("  #")) continue;
    const bool ends = !line.ends_with("\\");
    const std::string part = ends ? line : line.substr(0, line.size() - 1);
    goes_on ? examples.back() += part : examples.emplace_back(part);
    goes_on = !ends;
  }
  return examples;
}

std::vector<std::string> SplitWords(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

TEST(AppHelp, EachCommandHasExamplesThatParse) {
  const IdleProgram named;
  ASSERT_GE(named.commands.size(), 9u);
  for (const CLI::App* command : named.commands) {
    const std::vector<std::string> examples = ExamplesIn(command->help());
    EXPECT_FALSE(examples.empty()) << command->get_name();
    for (const std::string& example : examples) {
      std::vector<std::string> words = SplitWords(example);
      if (words.front() == "source") continue;  // a shell's own
      ASSERT_GE(words.size(), 2u);
      EXPECT_EQ(words[0], "armature");
      EXPECT_EQ(words[1], command->get_name());
      std::erase_if(words, [](const std::string& word) { return word.starts_with(">"); });
      std::reverse(words.begin(), words.end());
      words.pop_back();
      IdleProgram program;
      EXPECT_THROW(program.app.parse(words), CLI::Success) << example;
    }
  }
}

TEST(AppHelp, EachCommandSaysHowItEnds) {
  const IdleProgram program;
  for (const CLI::App* command : program.commands) {
    const std::string help = command->help();
    for (const char* heading : {"Usage: armature ", "\nGlobal options:\n", "\nExit status:\n"})
      EXPECT_NE(help.find(heading), std::string::npos) << command->get_name() << heading;
  }
}

TEST(AppHelp, LongTextsAreWrappedBesideTheirNames) {
  EXPECT_EQ(TwoColumns("--a", "one two three", {2, 7, 15}), "  --a  one two\n       three\n");
  EXPECT_EQ(TwoColumns("--long", "one two", {2, 7, 15}), "  --long\n       one two\n");
  EXPECT_EQ(Wrapped("a b\n\nc", 3), "a b\n\nc\n");
}

TEST(AppHelp, QuietAndVerboseMayStandBeforeOrAfterTheCommand) {
  for (const char* line : {"--quiet run s --out o", "run s --out o --quiet", "run --verbose s --out o"}) {
    IdleProgram program;
    EXPECT_THROW(program.app.parse(line), CLI::Success) << line;
  }
  IdleProgram program;
  EXPECT_THROW(program.app.parse("--quiet run s --out o --verbose"), CLI::ExcludesError);
  SetVerbosity(Verbosity::kNormal);
}

// What bash would offer for each of the lines, a line each.
std::string OfferedFor(const std::vector<std::string>& lines) {
  const testing::TempFolder folder;
  folder.Write("completion.bash", RunOk({"completion", "bash"}).out);
  std::filesystem::create_directories(folder / "tree/folder");
  folder.Write("tree/file.txt", "");
  std::string script = "compopt() { :; }; source ../completion.bash\n";
  for (const std::string& line : lines) {
    script += "COMP_LINE=" + testing::ShellQuoted(line) + "; COMP_POINT=${#COMP_LINE}\n";
    script += "_armature; echo \"${COMPREPLY[*]}\"\n";
  }
  folder.Write("ask.bash", script);
  const std::string command =
      "cd " + testing::ShellQuoted(folder / "tree") + " && bash --norc ../ask.bash >../answers 2>../errors";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(testing::ReadFile(folder / "errors"), "");
  return testing::ReadFile(folder / "answers");
}

TEST(AppCompletion, OffersWhatMayFollow) {
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"armature ret", "retrieve"},
      {"armature --qu", "--quiet"},
      {"armature run --pre", "--preset"},
      {"armature run --preset f", "fast"},
      {"armature run --preset=pa", "paper paper_meant"},
      {"armature --quiet run --verb", "--verbose"},
      {"armature run ", "folder"},
      {"armature run --config f", "file.txt folder"},
      {"armature run x --set lines.detec", "lines.detector="},
      {"armature retrieve --set expert.retrieval.index.le", "expert.retrieval.index.leaf_size="},
      {"armature eval --format la", "latex"},
      {"armature eval --tables objects,tra", "objects,trajectory"},
      {"armature bench --engines keypoints:w", "wait"},
      {"armature posegraph --init ch", "chordal"},
      {"armature completion ", "bash"}};
  std::vector<std::string> lines;
  std::string answers;
  for (const auto& [line, answer] : expected) {
    lines.push_back(line);
    answers += answer + "\n";
  }
  EXPECT_EQ(OfferedFor(lines), answers);
}

TEST(AppCompletion, RefusesUnknownShells) { testing::ExpectBadInput({"completion", "bsh"}, {"'bash'"}); }

}  // namespace
}  // namespace armature
