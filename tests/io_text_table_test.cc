// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/text_table.h"
#include "support/expect_input_error.h"

namespace armature {
namespace {

Table Sample() {
  return {.title = "Times",
          .columns = {"stage", "n", "median_ms"},
          .rows = {{TextCell("lines"), CountCell(250), NumberCell(2.625, 2)},
                   {TextCell("a|b, \"c\""), CountCell(0), NumberCell(std::nan(""), 2)}},
          .notes = {"median: wall clock"}};
}

TEST(TextTable, AlignsText) {
  EXPECT_EQ(FormatTable(Sample(), TableFormat::kText),
            "Times\n"
            "stage       n  median_ms\n"
            "------------------------\n"
            "lines     250       2.62\n"
            "a|b, \"c\"    0          -\n"
            "median: wall clock\n");
}

TEST(TextTable, WritesMarkdown) {
  EXPECT_EQ(FormatTable(Sample(), TableFormat::kMarkdown),
            "**Times**\n\n"
            "| stage     |   n | median_ms |\n"
            "| :-- | --: | --: |\n"
            "| lines     | 250 |      2.62 |\n"
            "| a\\|b, \"c\" |   0 |         - |\n"
            "\nmedian: wall clock\n");
}

TEST(TextTable, WritesCsv) {
  EXPECT_EQ(FormatTable(Sample(), TableFormat::kCsv),
            "# Times\nstage,n,median_ms\nlines,250,2.62\n\"a|b, \"\"c\"\"\",0,\n# median: wall clock\n");
}

TEST(TextTable, WritesLatex) {
  const std::string latex = FormatTable(Sample(), TableFormat::kLatex);
  EXPECT_NE(latex.find("\\begin{tabular}{lrr}"), std::string::npos);
  EXPECT_NE(latex.find("median\\_ms \\\\"), std::string::npos);
  EXPECT_NE(latex.find("\\end{tabular}"), std::string::npos);
}

TEST(TextTable, WritesJson) {
  const auto json = nlohmann::json::parse(FormatTable(Sample(), TableFormat::kJson));
  EXPECT_EQ(json["rows"][0]["n"], 250);
  EXPECT_TRUE(json["rows"][0]["n"].is_number_integer());
  EXPECT_EQ(json["rows"][0]["median_ms"], 2.62);
  EXPECT_TRUE(json["rows"][1]["median_ms"].is_null());
}

TEST(TextTable, CountsCharactersNotBytes) {
  const Table table{
      .title = "", .columns = {"a"}, .rows = {{TextCell("±1°")}, {TextCell("12345")}}, .notes = {}};
  EXPECT_EQ(FormatTable(table, TableFormat::kMarkdown), "| a     |\n| :-- |\n| ±1°   |\n| 12345 |\n");
}

TEST(TextTable, ShowsNoControlCharacters) {
  const Table table{.title = "a\nb",
                    .columns = {"\x1b[31mred"},
                    .rows = {{TextCell("\x1b]0;title\x07")}},
                    .notes = {"c\nd"}};
  for (const TableFormat format :
       {TableFormat::kText, TableFormat::kMarkdown, TableFormat::kCsv, TableFormat::kLatex}) {
    const std::string text = FormatTable(table, format);
    EXPECT_EQ(text.find_first_of("\x1b\x07"), std::string::npos) << text;
    EXPECT_NE(text.find("a?b"), std::string::npos) << text;
    EXPECT_NE(text.find("c?d"), std::string::npos) << text;
  }
  const auto json = nlohmann::json::parse(FormatTable(table, TableFormat::kJson));
  EXPECT_EQ(json["title"], "a\nb");
}

TEST(TextTable, KnowsItsFormats) {
  EXPECT_EQ(TableFormatFromName("latex"), TableFormat::kLatex);
  testing::ExpectInputError([] { TableFormatFromName("markdwon"); }, {"'markdwon'", "'markdown'"});
}

TEST(TextTable, RejectsIncompleteRows) {
  Table table = Sample();
  table.rows[0].pop_back();
  EXPECT_THROW(FormatTable(table, TableFormat::kText), std::logic_error);
}

}  // namespace
}  // namespace armature
