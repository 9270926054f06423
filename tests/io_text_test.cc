// SPDX-License-Identifier: BSD-3-Clause
// What all readers of text share: lines, words, numbers, and what may be opened at all.
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cmath>

#include "base/nearest_name.h"
#include "base/printable.h"
#include "base/text.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using Texts = std::vector<std::string>;

Texts LinesOf(const std::string& content, Comments comments = Comments::kAnywhere) {
  Texts lines;
  for (const TextLine& line : SplitLines(content, "a.txt", comments))
    lines.push_back(std::to_string(line.number) + ":" + line.text);
  return lines;
}

TEST(TextLines, EndInLfCrLfCrOrWithTheFile) {
  for (const char* content : {"a b\n\nc", "a b\r\n\r\nc\r\n", "a b\r\rc\r", "a b\n\r\nc\n"})
    EXPECT_EQ(LinesOf(content), (Texts{"1:a b", "3:c"})) << content;
  EXPECT_EQ(LinesOf("\xEF\xBB\xBFx\n"), Texts{"1:x"});
  EXPECT_EQ(LinesOf(""), Texts{});
}

TEST(TextLines, OfBlanksOfAnyKindAloneAreLeftOut) {
  EXPECT_EQ(LinesOf("\f\n\v\n \t\f\v\r\nx\f\n"), Texts{"4:x"});
  EXPECT_EQ(SplitWords("\f a\tb\v\fc\r"), (Texts{"a", "b", "c"}));
  EXPECT_EQ(SplitWords(" \f\v"), Texts{});
}

TEST(TextLines, CommentsBeginLinesOrFollowABlank) {
  EXPECT_EQ(LinesOf("# x\na#b # c\n\f#d\ne\f#f\n"), (Texts{"2:a#b", "4:e"}));
  EXPECT_EQ(LinesOf("  # x\na # b\n", Comments::kOwnLines), Texts{"2:a # b"});
}

TEST(TextLines, ZeroBytesAreNoText) {
  testing::ExpectInputError([] { LinesOf(std::string("a\nb\0c\n", 6)); }, {"a.txt:2", "zero byte"});
}

TEST(Numbers, AreReadAsOthersWriteThem) {
  const std::pair<const char*, double> numbers[] = {{"+0.5", 0.5},
                                                    {"1.5D-3", 0.0015},
                                                    {"-2d2", -200},
                                                    {"1e-400", 0},
                                                    {"-1e-400", 0},
                                                    {"5e-324", 5e-324},
                                                    {"+1.D+2", 100},
                                                    {"0.00000001e-320", 0},
                                                    {"1E5", 1e5},
                                                    {".5", 0.5},
                                                    {"100e-99999999999999999999", 0},
                                                    {"0e999999", 0}};
  for (const auto& [text, value] : numbers) EXPECT_EQ(ParseNumber(text, "a:1"), value) << text;
}

TEST(Numbers, ThatAreNoneOrTooLargeAreRefused) {
  for (const char* text : {"", "+", "-", "++1", "+-1", "d5", "1d", "1d5d5", "0x10", "nan", "inf", "+inf",
                           "1 2", "1,5", "infd0", "- 1", "1e"})
    testing::ExpectInputError([&] { ParseNumber(text, "a:1"); }, {"a:1", "not a finite number"});
  for (const char* text : {"1e400", "-1D400", "1e99999999999999999999", "12345678901e300"})
    testing::ExpectInputError([&] { ParseNumber(text, "a:1"); }, {"a:1", "too large"});
}

TEST(PrintableText, HasNoControlCharactersOfAnyLength) {
  EXPECT_EQ(Printable("a\x1b[31mb\n\x7f"), "a?[31mb??");
  EXPECT_EQ(Printable("\xC2\x9B"
                      "1m"),
            "?1m");  // CSI in one character
  EXPECT_EQ(Printable("a\xE2\x80\xAE"
                      "b"),
            "a?b");  // writes backwards
  EXPECT_EQ(Printable("\xff\xC3\xa4\xE4\xB8\xAD\xC3"), "?\xC3\xa4\xE4\xB8\xAD?");
  EXPECT_EQ(Printable(std::string_view("a\0b", 3)), "a?b");
  EXPECT_EQ(PrintableLines("a\n\rb\n"), "a\n?b\n");
}

TEST(PrintableText, IsCutBetweenCharacters) {
  const std::string shown = Quoted(std::string(79, 'x') + "\xC3\xA4" + std::string(1 << 20, 'y'));
  EXPECT_EQ(shown, "'" + std::string(79, 'x') + "...'");
}

TEST(NearestName, TakesLargeAndSmallLettersForTheSame) {
  EXPECT_EQ(NearestName("LSD", {"edlines", "fld", "lsd"}), "lsd");
}

TEST(NearestName, OfAHugeNameTakesNoTimeAndNoMemory) {
  const std::string huge(100'000'000, 'x');
  EXPECT_EQ(NearestName(huge, {"tx", std::string(200, 'x')}), std::string(200, 'x'));
  EXPECT_LT(UnknownNameMessage("column", huge, {"tx", "ty"}).size(), 300u);
}

TEST(InputFiles, OnlyRegularOnesAreOpened) {
  const testing::TempFolder folder;
  const auto refuse = [](const std::filesystem::path& file, const std::string& why) {
    testing::ExpectInputError([&] { ReadTextFile(file); }, {file.string(), why});
  };
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  refuse(folder / "pipe", "pipe");
  refuse(folder.path(), "is a folder");
  refuse("/dev/zero", "device");
  refuse("/dev/null", "device");
  std::filesystem::create_symlink("b", folder / "a");
  std::filesystem::create_symlink("a", folder / "b");
  refuse(folder / "a", "circle");
  refuse(folder / "none", "cannot be opened");
  sockaddr_un address{AF_UNIX, {}};
  const std::string socket_file = folder / "socket";
  socket_file.copy(address.sun_path, sizeof(address.sun_path) - 1);
  const int socket_number = socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind(socket_number, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  refuse(socket_file, "socket");
  close(socket_number);
}

TEST(InputFiles, ALinkToOneIsRead) {
  const testing::TempFolder folder;
  std::filesystem::create_symlink(folder.Write("file", std::string("a\0b", 3)), folder / "link");
  EXPECT_EQ(ReadTextFile(folder / "link"), std::string("a\0b", 3));
  EXPECT_EQ(ReadTextFile(folder.Write("empty", "")), "");
}

TEST(InputFiles, OfImpossibleSizeAreRefusedAtOnce) {
  const testing::TempFolder folder;
  const auto file = folder.Write("sparse", "");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40);
  testing::ExpectInputError([&] { ReadTextFile(file); }, {"sparse", "larger than 4 GB"});
}

}  // namespace
}  // namespace armature
