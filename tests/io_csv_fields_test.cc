// SPDX-License-Identifier: BSD-3-Clause
// Fields of CSV files: what is written is read again, whatever is in a name.
#include <gtest/gtest.h>

#include "base/csv_fields.h"
#include "io/csv.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using Fields = std::vector<std::string>;

TEST(CsvFields, AreQuotedOnlyWhereTheyHaveTo) {
  EXPECT_EQ(CsvField("office dev"), "office dev");
  EXPECT_EQ(CsvField(""), "");
  EXPECT_EQ(CsvField("a,b"), "\"a,b\"");
  EXPECT_EQ(CsvField("6\" chair"), "\"6\"\" chair\"");
  EXPECT_EQ(CsvField("two\nlines"), "\"two\nlines\"");
}

TEST(CsvFields, AreReadAsTheyWereWritten) {
  const Fields names{"a,b", "plain", "\"", "\"quoted\", and more", "", "6\" chair", ",,"};
  std::string line;
  for (const std::string& name : names) line += (line.empty() ? "" : ",") + CsvField(name);
  EXPECT_EQ(SplitCsvFields(line), names);
}

TEST(CsvFields, OfUsualLinesAreWhatIsBetweenTheCommas) {
  EXPECT_EQ(SplitCsvFields(" a , b,,c "), (Fields{"a", "b", "", "c"}));
  EXPECT_EQ(SplitCsvFields(""), Fields{""});
  EXPECT_EQ(SplitCsvFields("6\" chair,b"), (Fields{"6\" chair", "b"})) << "a quote inside is a character";
  EXPECT_EQ(SplitCsvFields(" \" a\" ,b"), (Fields{" a", "b"}));
  EXPECT_EQ(SplitCsvFields("\"a,"), (Fields{"a,"})) << "not closed";
  EXPECT_EQ(SplitCsvFields("\"a\","), (Fields{"a", ""}));
}

TEST(CsvFields, OfATableMayBeQuoted) {
  const testing::TempFolder folder;
  const CsvTable table(folder.Write("t.csv", "\"id\",category\n\"a,b\",chair\n"), {"id", "category"});
  EXPECT_EQ(table.rows().at(0).Text("id"), "a,b");
  EXPECT_EQ(table.rows().at(0).Text("category"), "chair");
}

}  // namespace
}  // namespace armature
